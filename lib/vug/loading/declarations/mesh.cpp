#include <vug/facade/carve.h>
#include <vug/loading/reader.h>
#include <vug/mesh/format.h>
#include <vug/mesh/normals.h>
#include <vug/mesh/weld.h>
#include <vug/paint/kind.h>
#include <vug/shot/mesh_source.h>

#include <fmt/format.h>

namespace vug::loading {
namespace {

std::vector<std::pair<std::string, std::string>> formats() {
  std::vector<std::pair<std::string, std::string>> names;
  for (const mesh::Format* format : mesh::formats())
    names.emplace_back(format->info.name, format->info.name);
  return names;
}

struct Block : shot::MeshPlan {
  std::filesystem::path file;
  double scale = 1;
  shot::MeshSource of;
  std::vector<field::Field> elements_of;
  double tolerance = 0.2e-3;
};

Schema<Block> schema() {
  Schema<Block> s("mesh", "declaration");
  s.doc(
       "A triangle mesh, written beside the .vdb: of a level set with mesh NAME on VOLUME { ... }, "
       "or from a file with mesh NAME { file \"rock.ply\" }, or of stems themselves, without a "
       "grid, with mesh NAME { of stems(of: PLANT) }.")
      .param("adaptivity", &shot::MeshPlan::adaptivity,
             {.doc = "0 keeps every face, 1 merges faces that are nearly flat", .min = 0, .max = 1})
      .param("polish", &shot::MeshPlan::polish,
             {.doc = "move vertices onto the exact field, keep creases"})
      .param("smallest_piece", &shot::MeshPlan::smallest_piece,
             {.doc = "leave out crumbs and closed bubbles whose box has a shorter diagonal",
              .dimension = Dimension::length,
              .min = 0})
      .param("paint", &shot::MeshPlan::paint, {.doc = "its vertex colours: a paint or one colour"})
      .param(
          "elements", &Block::elements_of,
          {.doc = "facades, or solids that they are carved into: the vertices tell of which node "
                  "and of which kind of element they are"})
      .choice("format", static_cast<std::string Block::*>(&shot::MeshPlan::format), formats(),
              "the file that is written");
  s.param("file", &Block::file, {.doc = "an OBJ, PLY or STL file, which may be open"})
      .param("scale", &Block::scale,
             {.doc = "metres in one unit of the file, e.g. 0.01 for centimetres",
              .min = 0,
              .above_min = true})
      .param("of", &Block::of,
             {.doc = "stems(...), an L-system whose polygons it is, leaf(...) or spray(...)"})
      .param("tolerance", &Block::tolerance,
             positive_length("that a straight edge around a stem may cut into it"));
  return s;
}

/// In metres. Without normals of its own it is taken for smooth, its vertices for one where they
/// are in one place.
mesh::Mesh read_file(const std::filesystem::path& file, double scale) {
  mesh::Mesh mesh = mesh::read_mesh(file);
  for (Vec3f& p : mesh.positions) p *= static_cast<float>(scale);
  if (mesh.normals.empty()) {
    mesh = mesh::welded(mesh);
    mesh.normals = mesh::vertex_normals(mesh);
  }
  mesh::validate(mesh, file.string());
  if (mesh.triangles.empty())
    throw Error(ErrorCode::bad_input, fmt::format("'{}' has no polygons", file.string()));
  return mesh;
}

/// A mesh that is empty: a film of growth may begin so, but it may be a slip.
void warn_of_nothing(const shot::MeshSource& drawn, const scene::Entry& entry,
                     Diagnostics& diagnostics) {
  diagnostics.warning(
      entry.values.at(0)->where,
      drawn.polygons ? "the L-system draws no polygons" : "there are no stems: the mesh is empty",
      drawn.polygons ? "for its stems: of stems(of: NAME)"
                     : "'vug derive --drawn' prints the word");
}

/// What the block says of a file; null with a diagnostic at what is at fault.
mesh::MeshPtr given(const Block& block, const scene::Declaration& declaration,
                    ReadContext& context) {
  const bool drawn = declaration.find_entry("of") != nullptr;
  const scene::Entry& entry = *declaration.find_entry(drawn ? "of" : "file");
  const char* source = drawn ? "of stems" : "from a file";
  if (declaration.target) {
    context.diagnostics.error(entry.where, fmt::format("a mesh {} stands on no volume", source),
                              fmt::format("leave out 'on' or '{}'", entry.key));
    return nullptr;
  }
  for (const char* key : {"adaptivity", "polish", "elements", drawn ? "file" : "tolerance"})
    if (const scene::Entry* other = declaration.find_entry(key)) {
      context.diagnostics.error(
          other->where, fmt::format("a mesh {} has no use for '{}'", source, key), "leave it out");
      return nullptr;
    }
  try {
    const auto made =
        std::make_shared<const mesh::Mesh>(drawn ? shot::mesh_from_source(block.of, block.tolerance)
                                                 : read_file(block.file, block.scale));
    if (made->triangles.empty()) warn_of_nothing(block.of, entry, context.diagnostics);
    return made;
  } catch (const Error& error) {
    const SourceLocation& there = error.where();
    const std::string what =
        there.known() ? fmt::format("{} (line {} of '{}')", error.what(), there.line, there.file)
                      : error.what();
    context.diagnostics.error(entry.values.at(0)->where, what, error.hint());
    return nullptr;
  }
}

/// What the block says of a level set; null with a diagnostic.
shot::VolumePtr read_volume(const scene::Declaration& declaration, ReadContext& context) {
  if (!declaration.value && !declaration.target) {
    context.diagnostics.error(
        declaration.where, "'mesh' needs 'on' and a volume, a file or 'of'",
        fmt::format("mesh {0} on NAME {{ ... }}, or mesh {0} {{ file \"NAME.ply\" }}",
                    declaration.name));
    return nullptr;
  }
  const shot::VolumePtr volume = read_target<shot::VolumePtr>(declaration, context);
  if (!volume || !volume->fog) return volume;
  context.diagnostics.error(declaration.where, "a mesh is made of a level set, not of a fog");
  return nullptr;
}

/// Fills plan.elements; false with a diagnostic where one of them is no facade.
bool tell_elements(const Block& block, const scene::Declaration& declaration, ReadContext& context,
                   shot::MeshPlan& plan) {
  for (const field::Field& each : block.elements_of) {
    const std::optional<facade::FacadeInstance> placed = facade::find_facade(each);
    if (!placed) {
      context.diagnostics.error(declaration.find_entry("elements")->where,
                                "'elements' are grammars of kind facade, or what carve(...) has "
                                "made with one",
                                "name the result of carve itself, before it is displaced");
      return false;
    }
    plan.elements.push_back(std::make_shared<const facade::FacadeInstance>(*placed));
  }
  return true;
}

}  // namespace

const DeclarationKind& mesh_declaration() {
  static const DeclarationKind kind = {
      schema().info(),
      [](const scene::Declaration& declaration, ReadContext& context) -> Value {
        std::optional<Block> block = read_block(schema(), declaration, context);
        const bool is_given = declaration.find_entry("file") || declaration.find_entry("of");
        const shot::VolumePtr volume = is_given ? nullptr : read_volume(declaration, context);
        if (!block) return Value();
        shot::MeshPlan plan = *block;
        plan.name = declaration.name;
        plan.volume = volume;
        if (!tell_elements(*block, declaration, context, plan)) return Value();
        if (is_given) plan.file_mesh = given(*block, declaration, context);
        if (!plan.volume && !plan.file_mesh) return Value();
        const shot::MeshPtr made = std::make_shared<const shot::MeshPlan>(std::move(plan));
        context.shot.meshes.push_back(made);
        return Object{"mesh", made};
      },
      "volume"};
  return kind;
}

}  // namespace vug::loading
