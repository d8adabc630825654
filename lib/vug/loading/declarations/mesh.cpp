// SPDX-License-Identifier: Apache-2.0
#include <vug/building/rock_weights.h>
#include <vug/facade/semantics.h>
#include <vug/loading/reader.h>
#include <vug/mesh/format.h>
#include <vug/mesh/normals.h>
#include <vug/mesh/rock_weights.h>
#include <vug/mesh/weld.h>
#include <vug/paint/kind.h>
#include <vug/shot/mesh_source.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::loading {
namespace {

std::vector<std::pair<std::string, std::string>> formats() {
  std::vector<std::pair<std::string, std::string>> names;
  for (const mesh::Format* format : mesh::formats())
    names.emplace_back(format->info.name, format->info.name);
  return names;
}

struct MeshBlock : shot::MeshPlan {
  std::filesystem::path file;
  double scale = 1;
  shot::MeshSource of;
  std::vector<field::Field> elements_of;
  double tolerance = 0.2e-3;
};

Schema<MeshBlock> mesh_schema() {
  Schema<MeshBlock> s("mesh", "declaration");
  s.doc(
       "A triangle mesh, written next to the .vdb: of a level set with mesh NAME on VOLUME { ... "
       "}, "
       "from a file with mesh NAME { file \"rock.ply\" }, or of stems, without a grid, with mesh "
       "NAME { of stems(of: PLANT) }.")
      .param("adaptivity", &shot::MeshPlan::adaptivity,
             {.doc = "0 keeps every face, 1 merges faces that are nearly flat", .min = 0, .max = 1})
      .param("polish", &shot::MeshPlan::polish,
             {.doc = "move vertices onto the exact field, keep creases"})
      .param(
          "smallest_piece", &shot::MeshPlan::smallest_piece,
          {.doc =
               "remove components, such as crumbs and closed bubbles, with a shorter box diagonal",
           .dimension = Dimension::length,
           .min = 0})
      .param("paint", &shot::MeshPlan::paint,
             {.doc = "vertex colours: a paint or one colour", .min = 0, .max = 1})
      .param(
          "elements", &MeshBlock::elements_of,
          {.doc = "facades, or solids that they are carved into: the vertices store their node and "
                  "their kind of element"})
      .param("labels", &shot::MeshPlan::labels,
             {.doc = "label(...) for each named part of the surface, e.g. passages of a cave: the "
                     "vertices store which of them is the nearest"})
      .choice("topology", static_cast<shot::SmallTopology MeshBlock::*>(&shot::MeshPlan::topology),
              {{"clean", shot::SmallTopology::clean}, {"keep", shot::SmallTopology::keep}},
              "bubbles and handles smaller than two voxels: clean removes them")
      .choice("format", static_cast<std::string MeshBlock::*>(&shot::MeshPlan::format), formats(),
              "format of the written file");
  s.param("file", &MeshBlock::file, {.doc = "an OBJ, PLY or STL file, which may be open"})
      .param("scale", &MeshBlock::scale,
             {.doc = "metres in one unit of the file, e.g. 0.01 for centimetres",
              .min = 0,
              .above_min = true})
      .param("of", &MeshBlock::of,
             {.doc = "stems(...), an L-system with polygons, leaf(...) or spray(...)"})
      .param("tolerance", &MeshBlock::tolerance,
             positive_length("by which straight edges around a stem may deviate from it"));
  return s;
}

/// Reads a mesh file, scaled to metres. A mesh without normals is assumed to be smooth; its
/// vertices at equal positions are merged.
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

/// Warns about an empty mesh: an animation of growth may begin with one, but it may be a mistake.
void warn_about_empty_mesh(const shot::MeshSource& drawn, const scene::Entry& entry,
                           Diagnostics& diagnostics) {
  diagnostics.warning(
      entry.values.at(0)->where,
      drawn.polygons ? "the L-system draws no polygons" : "there are no stems: the mesh is empty",
      drawn.polygons ? "for its stems: of stems(of: NAME)"
                     : "'vug derive --drawn' prints the word");
}

/// The plan of a mesh from a file or a source; null, with a diagnostic, for invalid entries.
mesh::MeshPtr read_source(const MeshBlock& block, const scene::Declaration& declaration,
                          ReadContext& context) {
  const bool drawn = declaration.find_entry("of") != nullptr;
  const scene::Entry& entry = *declaration.find_entry(drawn ? "of" : "file");
  const char* source = drawn ? "of stems" : "from a file";
  if (declaration.target) {
    context.diagnostics.error(entry.where, fmt::format("a mesh {} does not take 'on'", source),
                              fmt::format("remove 'on' or '{}'", entry.key));
    return nullptr;
  }
  for (const char* key :
       {"adaptivity", "polish", "topology", "elements", drawn ? "file" : "tolerance"})
    if (const scene::Entry* other = declaration.find_entry(key)) {
      context.diagnostics.error(
          other->where, fmt::format("a mesh {} does not use '{}'", source, key), "leave it out");
      return nullptr;
    }
  try {
    const auto made =
        std::make_shared<const mesh::Mesh>(drawn ? shot::mesh_from_source(block.of, block.tolerance)
                                                 : read_file(block.file, block.scale));
    if (made->triangles.empty()) warn_about_empty_mesh(block.of, entry, context.diagnostics);
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

/// The plan of a mesh of a level set; null with a diagnostic.
shot::VolumePtr read_volume(const scene::Declaration& declaration, ReadContext& context) {
  if (!declaration.value && !declaration.target) {
    context.diagnostics.error(
        declaration.where, "'mesh' needs 'on' and a volume, a file or 'of'",
        fmt::format("mesh {0} on NAME {{ ... }}, or mesh {0} {{ file \"NAME.ply\" }}",
                    scene::name_without_index(declaration.name)));
    return nullptr;
  }
  const shot::VolumePtr volume = read_target<shot::VolumePtr>(declaration, context);
  if (!volume || !volume->fog) return volume;
  context.diagnostics.error(declaration.where, "a mesh needs a level set, not a fog");
  return nullptr;
}

/// Fills plan.elements; false, with a diagnostic, for values that are not facades.
bool read_elements(const MeshBlock& block, const scene::Declaration& declaration,
                   ReadContext& context, shot::MeshPlan& plan) {
  for (const field::Field& each : block.elements_of) {
    const std::optional<facade::FacadeInstance> placed = facade::find_facade(each);
    if (!placed) {
      context.diagnostics.error(
          declaration.find_entry("elements")->where,
          "'elements' must be grammars of kind facade, or results of carve(...) "
          "with one",
          "name the result of carve itself, before it is displaced");
      return false;
    }
    plan.elements.push_back(std::make_shared<const facade::FacadeInstance>(*placed));
  }
  return true;
}

/// Reports labels whose attributes would have the names of others, or that are too many.
bool check_labels(const shot::MeshPlan& plan, const scene::Declaration& declaration,
                  ReadContext& context) {
  constexpr size_t kMostLabels = 256;
  const std::vector<std::string> names = shot::label_names(plan.labels);
  const auto refuse = [&](const std::string& problem, const std::string& hint) {
    context.diagnostics.error(declaration.find_entry("labels")->where, problem, hint);
    return false;
  };
  if (names.size() > kMostLabels)
    return refuse(fmt::format("{} labels are too many for one mesh; at most {} are possible",
                              names.size(), kMostLabels),
                  "use one label for several parts: labels of the same name count as one");
  std::vector<std::string> taken = facade::semantic_names(plan.elements);
  if (plan.elements.empty()) taken.clear();
  taken.emplace_back(mesh::kColour);
  if (plan.volume)
    for (const std::string& material : building::materials_of(*plan.volume))
      taken.push_back(mesh::weight_attribute(material));
  for (const std::string& name : names)
    if (std::find(taken.begin(), taken.end(), name) != taken.end())
      return refuse(fmt::format("the mesh has an attribute '{}' already", name),
                    "choose another name for the label");
  return true;
}

}  // namespace

const DeclarationKind& mesh_declaration() {
  static const DeclarationKind kind = {
      mesh_schema().info(),
      [](const scene::Declaration& declaration, ReadContext& context) -> Value {
        if (const scene::Entry* entry = declaration.find_entry("material")) {
          context.diagnostics.error(
              entry->where, "'mesh' has no parameter 'material'",
              fmt::format("a material belongs to an object: object NAME on {} {{ material ... }}",
                          declaration.name));
          return Value();
        }
        std::optional<MeshBlock> block = read_block(mesh_schema(), declaration, context);
        const bool is_given = declaration.find_entry("file") || declaration.find_entry("of");
        const shot::VolumePtr volume = is_given ? nullptr : read_volume(declaration, context);
        if (!block) return Value();
        shot::MeshPlan plan = *block;
        plan.name = declaration.name;
        plan.volume = volume;
        if (!read_elements(*block, declaration, context, plan)) return Value();
        if (!check_labels(plan, declaration, context)) return Value();
        if (is_given) plan.file_mesh = read_source(*block, declaration, context);
        plan.drawn = declaration.find_entry("of") != nullptr;
        if (!plan.volume && !plan.file_mesh) return Value();
        const shot::MeshPtr made = std::make_shared<const shot::MeshPlan>(std::move(plan));
        context.shot.meshes.push_back(made);
        return Object{"mesh", made};
      },
      "volume"};
  return kind;
}

}  // namespace vug::loading
