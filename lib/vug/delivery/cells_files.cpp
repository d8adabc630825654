// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/memory.h>
#include <vug/building/make_mesh.h>
#include <vug/cells/transfer_to_mesh.h>
#include <vug/delivery/cells_files.h>
#include <vug/mesh/byte_writer.h>
#include <vug/volume/band.h>
#include <vug/volume/io.h>
#include <vug/volume/level_set_field.h>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <set>

namespace vug::delivery {
namespace {

/// The supporting meshes that are surfaces of level sets, one for each level set.
std::vector<shot::MeshPtr> solid_supports(const shot::CellsPlan& plan) {
  std::vector<shot::MeshPtr> out;
  std::set<shot::VolumePtr> known;
  for (const shot::MeshPtr& mesh : plan.on)
    if (mesh->volume && known.insert(mesh->volume).second) out.push_back(mesh);
  return out;
}

/// Vertices without triangles: the nearest surface points of the voxels in the band.
mesh::Mesh surface_points(const shot::MeshPlan& support, const volume::LevelSet& level_set) {
  volume::BandPoints band = volume::band_points(level_set);
  mesh::Mesh out;
  out.positions = std::move(band.foot);
  out.normals = std::move(band.normal);
  if (support.paint)
    building::add_colors(out, support.paint, volume::sampled_grid(level_set).get());
  return out;
}

volume::Grid grid_of(const mesh::Attribute& attribute, const volume::LevelSet& level_set) {
  if (attribute.arity != 3) return volume::band_grid(level_set, attribute.values);
  std::vector<Vec3f> vectors(attribute.values.size() / 3);
  for (size_t i = 0; i < vectors.size(); ++i)
    vectors[i] = {attribute.values[3 * i], attribute.values[3 * i + 1],
                  attribute.values[3 * i + 2]};
  return volume::band_grid(level_set, vectors);
}

/// Writes the column names of an attribute.
void write_names(mesh::ByteWriter& out, const std::string& name, const std::vector<float>&) {
  out.text(",").text(name);
}
void write_names(mesh::ByteWriter& out, const std::string& name, const std::vector<int32_t>&) {
  out.text(",").text(name);
}
void write_names(mesh::ByteWriter& out, const std::string& name, const std::vector<Vec3f>&) {
  for (const char* part : {"_x", "_y", "_z"}) out.text(",").text(name).text(part);
}

template <class T>
void write_value(mesh::ByteWriter& out, const T& value) {
  if constexpr (std::is_same_v<T, Vec3f>)
    out.text(",").number(value.x).text(",").number(value.y).text(",").number(value.z);
  else
    out.text(",").number(value);
}

}  // namespace

std::vector<volume::Grid> cell_grids(building::Builder& builder, const shot::CellsPtr& plan) {
  constexpr double kBytes = 200;  // memory per voxel while its values are computed
  std::vector<volume::Grid> out;
  const building::CellLayerPtr layer = builder.cell_layer(plan);
  const std::vector<shot::MeshPtr> grounds = solid_supports(*plan);
  for (const shot::MeshPtr& support : grounds) {
    const volume::LevelSet& level_set = builder.level_set(support->volume);
    require_memory(kBytes * static_cast<double>(level_set.statistics().active_voxels),
                   builder.memory_budget(), fmt::format("the grids of '{}'", plan->name),
                   "exclude grids from its files, or use larger voxels");
    mesh::Mesh places = surface_points(*support, level_set);
    cells::transfer_to_mesh(layer->simulation, places, {}, builder.progress());
    const std::string name =
        grounds.size() == 1 ? plan->name : fmt::format("{}_{}", plan->name, support->volume->name);
    for (const mesh::Attribute& each : places.attributes)
      out.push_back(grid_of(each, level_set)
                        .named(fmt::format("{}_{}", name, each.name))
                        .stored_as_half(plan->half));
  }
  return out;
}

void write_table(const std::filesystem::path& file, const building::CellLayer& layer) {
  const volume::Points points = cells::to_points(layer.simulation);
  AtomicFile target(file);
  std::ofstream to(target.path(), std::ios::binary);
  const mesh::ByteSink sink = [&](std::string_view bytes) {
    to.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  };
  mesh::ByteWriter out(sink);
  out.text("id,x,y,z");
  for (const volume::PointAttribute& each : points.attributes)
    if (each.name != "id")
      std::visit([&](const auto& values) { write_names(out, each.name, values); }, each.values);
  out.text(",state\n");
  for (size_t i = 0; i < points.size(); ++i) {
    out.number(i);
    write_value(out, points.position[i]);
    for (const volume::PointAttribute& each : points.attributes)
      if (each.name != "id")
        std::visit([&](const auto& values) { write_value(out, values[i]); }, each.values);
    out.text(",").text(cells::name_of(layer.simulation.states()[i])).text("\n");
  }
  out.finish();
  to.close();
  if (!to)
    throw Error(ErrorCode::io,
                fmt::format("cannot write '{}': {}", file.string(), std::strerror(errno)));
  target.commit();
}

}  // namespace vug::delivery
