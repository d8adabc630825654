// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/sky.h>
#include <vug/exchange/usd_header.h>
#include <vug/exchange/usd_light.h>
#include <vug/exchange/usd_mesh.h>
#include <vug/exchange/usda_writer.h>
#include <vug/mesh/file.h>

#include <optional>

namespace vug::exchange {

UsdaWriter::UsdaWriter(const Assembly& assembly, const FormatOptions& options, UsdText& out,
                       std::filesystem::path file, WriteReport& written)
    : assembly_(assembly),
      options_(options),
      out_(out),
      file_(std::move(file)),
      written_(written),
      root_(identifier(assembly.name)) {}

void UsdaWriter::write(Progress& progress) {
  begin();
  each_part([](const Part& write) { write(); }, progress);
  end();
}

void UsdaWriter::begin(const std::vector<std::string>& metadata) {
  write_usd_header(out_, root_, assembly_.provenance, assembly_.space);
  std::vector<std::string> all = {"kind = \"assembly\""};
  all.insert(all.end(), metadata.begin(), metadata.end());
  out_.def("Xform", root_, all);
}
void UsdaWriter::end() {
  out_.end();
  out_.finish();
}

void UsdaWriter::each_part(const std::function<void(const Part&)>& visit, Progress& progress) {
  visit([&] { materials(); });
  progress.begin("USD", assembly_.groups.size());
  for (const InstanceGroup& group : assembly_.groups) {
    progress.check();
    visit([&] { add(group); });
    progress.advance();
  }
  progress.end();
  for (const Volume& volume : assembly_.volumes) visit([&] { add(volume); });
  for (const Camera& camera : assembly_.cameras)
    visit([&] {
      write_usd_camera(out_, camera, names_.unique(camera.name), assembly_.space.metres_per_unit);
    });
  for (const Light& light : assembly_.lights) visit([&] { add(light); });
}

void UsdaWriter::materials() {
  names_.unique("materials");
  out_.def("Scope", "materials");
  UniqueNames names;
  for (size_t i = 0; i < assembly_.prototypes.size(); ++i) {
    const Prototype& prototype = assembly_.prototypes[i];
    if (prototype.look.through != Vec3d(0.0))
      written_.unsupported.push_back(fmt::format("the light transmitted by '{}'", prototype.name));
    UsdMaterials& own = materials_[i];
    for (size_t j = 0; j < i && own.whole.empty(); ++j)
      if (same_usd_material(assembly_.prototypes[j], prototype)) own = materials_[j];
    if (!own.whole.empty()) continue;
    const auto write = [&](const Prototype& look) {
      const std::string name = names.unique(look.material);
      const std::string path = fmt::format("/{}/materials/{}", root_, name);
      write_usd_material(out_, look, path, name);
      return path;
    };
    own.whole = write(prototype);
    for (const RockLook& rock : prototype.rocks)
      own.rocks[rock.rock] = write(of_rock(prototype, rock));
  }
  out_.end();
}

/// Writes a mesh at that path, or a reference to its first occurrence. A reference into a variant
/// would not follow the choice of the variant.
void UsdaWriter::mesh(size_t part, const std::string& parent, const std::string& name) {
  const auto [known, fresh] = meshes_.try_emplace(part, parent + "/" + name);
  if (fresh || !options_.variants.empty())
    return write_usd_mesh(out_, assembly_.prototypes[part], name, materials_.at(part));
  out_.def(usd_mesh_type(assembly_.prototypes[part]), name,
           {fmt::format("prepend references = <{}>", known->second)})
      .end();
}

void UsdaWriter::add(const InstanceGroup& group) {
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

void UsdaWriter::add_instances(const InstanceGroup& group,
                               const std::vector<TrsTransform>& places) {
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

Box3d UsdaWriter::box_of(const InstanceGroup& group) const {
  const Box3d own = mesh::bounds(*assembly_.prototypes.at(group.prototype).mesh);
  Box3d all;
  if (!own.isEmpty())
    for (const Transform& place : group.places) all.extendBy(place.box(own));
  return all.isEmpty() ? Box3d(Vec3d(0.0), Vec3d(0.0)) : all;
}

void UsdaWriter::add(const Volume& volume) {
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
    out_.line("token fieldDataType = \"{}\"", grid.color ? "float3" : grid.whole ? "int" : "float");
    if (grid.color) out_.line("token vectorDataRoleHint = \"Color\"");
    out_.end();
  }
  out_.end();
}

void UsdaWriter::add(const Light& light) {
  const std::string name = names_.unique(light.name);
  std::string picture;
  if (const auto path = sky_file(light, file_, name)) {
    if (writes_skies_) written_.files.push_back(*write_sky(light, file_, name));
    picture = "./" + path->filename().string();
  }
  write_usd_light(out_, light, name, picture);
}

}  // namespace vug::exchange
