// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/sky.h>
#include <vug/exchange/usd_file.h>
#include <vug/exchange/usd_light.h>
#include <vug/exchange/usd_mesh.h>
#include <vug/exchange/usd_variants.h>
#include <vug/exchange/usd_writer.h>

#include <fmt/format.h>

#include <optional>

namespace vug::exchange {

UsdWriter::UsdWriter(const Assembly& assembly, const FormatOptions& options, UsdLayer& out,
                     std::filesystem::path file, WriteReport& written)
    : assembly_(assembly),
      options_(options),
      out_(&out),
      file_(std::move(file)),
      written_(written),
      root_(identifier(assembly.name)) {}

void UsdWriter::write(Progress& progress) {
  begin();
  each_part([](const Part& write) { write(); }, progress);
  end();
}

void UsdWriter::begin(const UsdPrimMetadata& metadata) {
  out_->header({root_, assembly_.provenance, assembly_.space});
  UsdPrimMetadata all = {usd_kind("assembly")};
  all.insert(all.end(), metadata.begin(), metadata.end());
  out_->begin_prim("Xform", root_, all);
}
void UsdWriter::end() { out_->end(); }

void UsdWriter::each_part(const std::function<void(const Part&)>& visit, Progress& progress) {
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
      write_usd_camera(*out_, camera, names_.unique(camera.name), assembly_.space.metres_per_unit);
    });
  for (const Light& light : assembly_.lights) visit([&] { add(light); });
}

void UsdWriter::materials() {
  names_.unique("materials");
  out_->begin_prim("Scope", "materials");
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
      write_usd_material(*out_, look, path, name);
      return path;
    };
    own.whole = write(prototype);
    for (const RockLook& rock : prototype.rocks)
      own.rocks[rock.rock] = write(of_rock(prototype, rock));
  }
  out_->end();
}

/// Writes a mesh at that path, or a reference to its first occurrence. A reference into a variant
/// would not follow the choice of the variant.
void UsdWriter::mesh(size_t part, const std::string& parent, const std::string& name) {
  const auto [known, fresh] = meshes_.try_emplace(part, parent + "/" + name);
  if (fresh || !options_.variants.empty())
    return write_usd_mesh(*out_, assembly_.prototypes[part], name, materials_.at(part));
  out_->begin_prim(usd_mesh_type(assembly_.prototypes[part]), name, {usd_reference(known->second)});
  out_->end();
}

void UsdWriter::add(const InstanceGroup& group) {
  std::vector<TrsTransform> places;
  std::vector<Transform> alone;
  const bool many = group.places.size() > 1 && options_.instancing;
  for (const Transform& place : group.places) {
    const auto parts = many ? decompose_trs(place) : std::nullopt;
    parts ? places.push_back(*parts) : alone.push_back(place);
  }
  for (const Transform& place : alone) {
    const std::string name = names_.unique(group.name);
    out_->begin_prim("Xform", name);
    mesh(group.prototype, fmt::format("/{}/{}", root_, name), "mesh");
    out_->transform(place);
    out_->end();
  }
  if (!places.empty()) add_instances(group, places);
}

void UsdWriter::add_instances(const InstanceGroup& group, const std::vector<TrsTransform>& places) {
  const std::string name = names_.unique(group.name);
  const std::string path = fmt::format("/{}/{}", root_, name);
  std::vector<float> moves, turns, scales;
  for (const TrsTransform& each : places) {
    for (int i = 0; i < 3; ++i) moves.push_back(static_cast<float>(each.translation[i]));
    for (int i = 0; i < 3; ++i) scales.push_back(static_cast<float>(each.scale[i]));
    for (const size_t i : {3u, 0u, 1u, 2u}) turns.push_back(static_cast<float>(each.rotation[i]));
  }
  const std::vector<int32_t> first(places.size(), 0);
  out_->begin_prim("PointInstancer", name);
  const Box3d box = box_of(group);
  const size_t count = places.size();
  out_->attribute({"float3", "extent"}, UsdTuples{box.min, box.max});
  out_->relationships("prototypes", {path + "/Prototypes/mesh"});
  out_->attribute({"int", "protoIndices"}, UsdArray{first.data(), count});
  out_->attribute({"point3f", "positions"}, UsdArray{moves.data(), count, 3});
  out_->attribute({"quath", "orientations"}, UsdArray{turns.data(), count, 4});
  out_->attribute({"quatf", "orientationsf"}, UsdArray{turns.data(), count, 4});
  out_->attribute({"float3", "scales"}, UsdArray{scales.data(), count, 3});
  out_->begin_prim("Scope", "Prototypes");
  mesh(group.prototype, path + "/Prototypes", "mesh");
  out_->end();
  out_->end();
}

Box3d UsdWriter::box_of(const InstanceGroup& group) const {
  const Box3d own = mesh::bounds(*assembly_.prototypes.at(group.prototype).mesh);
  Box3d all;
  if (!own.isEmpty())
    for (const Transform& place : group.places) all.extendBy(place.box(own));
  return all.isEmpty() ? Box3d(Vec3d(0.0), Vec3d(0.0)) : all;
}

void UsdWriter::add(const Volume& volume) {
  const std::string name = names_.unique(volume.name);
  out_->begin_prim("Volume", name);
  if (!volume.bounds.isEmpty())
    out_->attribute({"float3", "extent"}, UsdTuples{volume.bounds.min, volume.bounds.max});
  if (volume.medium) {
    const auto number = [&](const char* what, double value) {
      out_->attribute({.type = "double", .name = what, .custom = true}, value);
    };
    const auto color = [&](const char* what, const Vec3d& value) {
      out_->attribute({.type = "color3f", .name = what, .custom = true},
                      UsdTuple{value.x, value.y, value.z});
    };
    number("vug:extinction", volume.medium->extinction);
    color("vug:albedo", volume.medium->albedo);
    number("vug:forward", volume.medium->forward);
    color("vug:emission", volume.medium->emission);
    number("vug:heat", volume.medium->heat);
  }
  for (const VolumeGrid& grid : volume.grids)
    out_->relationship("field:" + identifier(grid.name),
                       fmt::format("/{}/{}/{}", root_, name, identifier(grid.name)));
  for (const VolumeGrid& grid : volume.grids) {
    const auto token = [&](const char* what, const std::string& value) {
      out_->attribute({"token", what}, UsdToken{value});
    };
    out_->begin_prim("OpenVDBAsset", identifier(grid.name));
    out_->attribute({"asset", "filePath"}, UsdAsset{"./" + volume.file});
    token("fieldName", grid.name);
    token("fieldClass", grid.grid_class == "level set"    ? "levelSet"
                        : grid.grid_class == "fog volume" ? "fogVolume"
                                                          : "unknown");
    token("fieldDataType", grid.color ? "float3" : grid.whole ? "int" : "float");
    if (grid.color) token("vectorDataRoleHint", "Color");
    out_->end();
  }
  out_->end();
}

void UsdWriter::add(const Light& light) {
  const std::string name = names_.unique(light.name);
  std::string picture;
  if (const auto path = sky_file(light, file_, name)) {
    if (writes_skies_) written_.files.push_back(*write_sky(light, file_, name));
    picture = "./" + path->filename().string();
  }
  write_usd_light(*out_, light, name, picture);
}

WriteReport write_usd_assembly(const Assembly& assembly, const std::filesystem::path& file,
                               const FormatOptions& options, Progress& progress) {
  WriteReport written{{file}, {}};
  write_usd_file(file, [&](UsdLayer& layer) {
    if (options.variants.empty())
      UsdWriter(assembly, options, layer, file, written).write(progress);
    else
      write_usd_variants(assembly, file, options, layer, written, progress);
  });
  return written;
}

}  // namespace vug::exchange
