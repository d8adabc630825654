// SPDX-License-Identifier: Apache-2.0
// USD as text: a layer that can be written without a library.
#include <vug/base/atomic_file.h>
#include <vug/exchange/format.h>
#include <vug/exchange/names.h>
#include <vug/exchange/sky.h>
#include <vug/exchange/trs.h>
#include <vug/exchange/usd_light.h>
#include <vug/exchange/usd_mesh.h>
#include <vug/mesh/file.h>

#include <fmt/format.h>

#include <map>
#include <optional>

namespace vug::exchange {
namespace {

class UsdaWriter {
 public:
  UsdaWriter(const Assembly& assembly, const FormatOptions& options, UsdText& out,
             std::filesystem::path file, WriteReport& written)
      : assembly_(assembly),
        options_(options),
        out_(out),
        file_(std::move(file)),
        written_(written),
        root_(identifier(assembly.name)) {}

  void write(Progress& progress) {
    header();
    out_.def("Xform", root_, {"kind = \"assembly\""});
    materials();
    progress.begin("USD", assembly_.groups.size());
    for (const InstanceGroup& group : assembly_.groups) {
      progress.check();
      add(group);
      progress.advance();
    }
    progress.end();
    for (const Volume& volume : assembly_.volumes) add(volume);
    for (const Camera& camera : assembly_.cameras)
      write_usd_camera(out_, camera, names_.unique(camera.name), assembly_.space.metres_per_unit);
    for (const Light& light : assembly_.lights) add(light);
    out_.end();
    out_.finish();
  }

 private:
  void header() {
    const Provenance& from = assembly_.provenance;
    out_.line("#usda 1.0").line("(").line("    customLayerData = {{");
    out_.line("        string \"vug:recipe\" = {}", usd_string(from.recipe));
    out_.line("        string \"vug:seed\" = \"{}\"", from.seed);
    out_.line("        double \"vug:frame\" = {}", from.frame);
    out_.line("        string \"vug:version\" = {}", usd_string(from.version));
    out_.line("    }}").line("    defaultPrim = \"{}\"", root_);
    out_.line("    metersPerUnit = {}", assembly_.space.metres_per_unit);
    out_.line("    upAxis = \"{}\"", assembly_.space.up == UpAxis::y ? "Y" : "Z").line(")");
  }

  void materials() {
    names_.unique("materials");
    out_.def("Scope", "materials");
    UniqueNames names;
    for (size_t i = 0; i < assembly_.prototypes.size(); ++i) {
      const Prototype& prototype = assembly_.prototypes[i];
      if (prototype.look.through != Vec3d(0.0))
        written_.unsupported.push_back(
            fmt::format("the light transmitted by '{}'", prototype.name));
      std::string& path = material_[i];
      for (size_t j = 0; j < i && path.empty(); ++j)
        if (same_usd_material(assembly_.prototypes[j], prototype)) path = material_[j];
      if (!path.empty()) continue;
      const std::string name = names.unique(prototype.material);
      path = fmt::format("/{}/materials/{}", root_, name);
      write_usd_material(out_, prototype, path, name);
    }
    out_.end();
  }

  /// Writes a mesh at that path, or a reference to its first occurrence.
  void mesh(size_t part, const std::string& parent, const std::string& name) {
    const auto [known, fresh] = meshes_.try_emplace(part, parent + "/" + name);
    if (fresh) return write_usd_mesh(out_, assembly_.prototypes[part], name, material_.at(part));
    out_.def(usd_mesh_type(assembly_.prototypes[part]), name,
             {fmt::format("prepend references = <{}>", known->second)})
        .end();
  }

  void add(const InstanceGroup& group) {
    std::vector<TrsTransform> places;
    std::vector<Transform> alone;
    const bool many = group.places.size() > 1 && options_.instancing;
    for (const Transform& place : group.places) {
      const auto parts = many ? decompose_trs(place) : std::nullopt;
      parts ? places.push_back(*parts) : alone.push_back(place);
    }
    for (const Transform& place : alone) {
      const std::string name = names_.unique(group.name);
      out_.def("Xform", name);
      mesh(group.prototype, fmt::format("/{}/{}", root_, name), "mesh");
      out_.place(place).end();
    }
    if (!places.empty()) add_instances(group, places);
  }

  void add_instances(const InstanceGroup& group, const std::vector<TrsTransform>& places) {
    const std::string name = names_.unique(group.name);
    const std::string path = fmt::format("/{}/{}", root_, name);
    std::vector<float> moves, turns, scales;
    for (const TrsTransform& each : places) {
      for (int i = 0; i < 3; ++i) moves.push_back(static_cast<float>(each.translation[i]));
      for (int i = 0; i < 3; ++i) scales.push_back(static_cast<float>(each.scale[i]));
      for (const size_t i : {3u, 0u, 1u, 2u}) turns.push_back(static_cast<float>(each.rotation[i]));
    }
    const std::vector<int> first(places.size(), 0);
    out_.def("PointInstancer", name);
    const Box3d box = box_of(group);
    out_.line("float3[] extent = [{}, {}]", usd_tuple(box.min), usd_tuple(box.max));
    out_.line("rel prototypes = [<{}/Prototypes/mesh>]", path);
    out_.array("int", "protoIndices", first.data(), first.size(), 1);
    out_.array("point3f", "positions", moves.data(), places.size(), 3);
    out_.array("quath", "orientations", turns.data(), places.size(), 4);
    out_.array("quatf", "orientationsf", turns.data(), places.size(), 4);
    out_.array("float3", "scales", scales.data(), places.size(), 3);
    out_.def("Scope", "Prototypes");
    mesh(group.prototype, path + "/Prototypes", "mesh");
    out_.end().end();
  }

  Box3d box_of(const InstanceGroup& group) const {
    const Box3d own = mesh::bounds(*assembly_.prototypes.at(group.prototype).mesh);
    Box3d all;
    if (!own.isEmpty())
      for (const Transform& place : group.places) all.extendBy(place.box(own));
    return all.isEmpty() ? Box3d(Vec3d(0.0), Vec3d(0.0)) : all;
  }

  void add(const Volume& volume) {
    const std::string name = names_.unique(volume.name);
    out_.def("Volume", name);
    if (!volume.bounds.isEmpty())
      out_.line("float3[] extent = [{}, {}]", usd_tuple(volume.bounds.min),
                usd_tuple(volume.bounds.max));
    if (volume.medium) {
      out_.line("custom double vug:extinction = {}", volume.medium->extinction);
      out_.line("custom color3f vug:albedo = {}", usd_tuple(volume.medium->albedo));
      out_.line("custom double vug:forward = {}", volume.medium->forward);
      out_.line("custom color3f vug:emission = {}", usd_tuple(volume.medium->emission));
      out_.line("custom double vug:heat = {}", volume.medium->heat);
    }
    for (const VolumeGrid& grid : volume.grids)
      out_.line("rel field:{} = </{}/{}/{}>", identifier(grid.name), root_, name,
                identifier(grid.name));
    for (const VolumeGrid& grid : volume.grids) {
      out_.def("OpenVDBAsset", identifier(grid.name));
      out_.line("asset filePath = @./{}@", volume.file);
      out_.line("token fieldName = \"{}\"", grid.name);
      out_.line("token fieldClass = \"{}\"", grid.grid_class == "level set"    ? "levelSet"
                                             : grid.grid_class == "fog volume" ? "fogVolume"
                                                                               : "unknown");
      out_.line("token fieldDataType = \"{}\"", grid.color ? "float3" : "float");
      if (grid.color) out_.line("token vectorDataRoleHint = \"Color\"");
      out_.end();
    }
    out_.end();
  }

  void add(const Light& light) {
    const std::string name = names_.unique(light.name);
    std::string picture;
    if (const auto path = write_sky(light, file_, name)) {
      written_.files.push_back(*path);
      picture = "./" + path->filename().string();
    }
    write_usd_light(out_, light, name, picture);
  }

  const Assembly& assembly_;
  const FormatOptions& options_;
  UsdText& out_;
  std::filesystem::path file_;
  WriteReport& written_;
  std::string root_;
  UniqueNames names_;
  std::map<size_t, std::string> meshes_, material_;
};

WriteReport write_usda(const Assembly& assembly, const std::filesystem::path& file,
                       const FormatOptions& options, Progress& progress) {
  WriteReport written{{file}, {}};
  mesh::write_file(file, [&](const mesh::ByteSink& sink) {
    UsdText text(sink);
    UsdaWriter(assembly, options, text, file, written).write(progress);
  });
  return written;
}

/// Reads the lines `string "vug:NAME" = "..."` before the first prim.
std::vector<std::pair<std::string, std::string>> read_usda(std::string_view bytes,
                                                           const std::string& file) {
  if (bytes.substr(0, 5) != "#usda")
    throw Error(ErrorCode::bad_input, "the file is not a USD text", {file, 1, 1});
  const bool whole = bytes.size() >= 3 && bytes.substr(bytes.size() - 3) == "\n}\n";
  bytes = bytes.substr(0, bytes.find("\ndef "));
  constexpr std::string_view kBegin = "string \"vug:", kEquals = "\" = \"";
  std::vector<std::pair<std::string, std::string>> texts;
  for (size_t at = bytes.find(kBegin); at != std::string_view::npos; at = bytes.find(kBegin, at)) {
    at += kBegin.size();
    const size_t end = bytes.find(kEquals, at);
    if (end == std::string_view::npos) break;
    const std::string name = "vug:" + std::string(bytes.substr(at, end - at));
    std::string text;
    for (at = end + kEquals.size(); at < bytes.size() && bytes[at] != '"'; ++at) {
      const bool escape = bytes[at] == '\\' && at + 1 < bytes.size();
      const char c = bytes[escape ? ++at : at];
      text += !escape ? c : c == 'n' ? '\n' : c == 'r' ? '\r' : c == 't' ? '\t' : c;
    }
    texts.emplace_back(name, std::move(text));
  }
  if (!texts.empty() && !whole)
    throw Error(ErrorCode::bad_input, "the file is truncated: its last prim is not closed",
                {file, 0, 0});
  return texts;
}

}  // namespace
}  // namespace vug::exchange

VUG_EXCHANGE_FORMAT(usda) {
  return {{"usda",
           "exchange format",
           "USD as text: meshes with primvars and preview surfaces, instances, volumes, cameras "
           "and lights of any shape",
           "usd",
           {}},
          std::nullopt,
          true,
          write_usda,
          read_usda};
}
