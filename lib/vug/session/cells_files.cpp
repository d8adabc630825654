#include <vug/base/atomic_file.h>
#include <vug/base/memory.h>
#include <vug/cells/onto_mesh.h>
#include <vug/mesh/output.h>
#include <vug/session/blame.h>
#include <vug/session/cells_files.h>
#include <vug/session/make_mesh.h>
#include <vug/volume/band.h>
#include <vug/volume/io.h>
#include <vug/volume/samples.h>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <set>

namespace vug::session {
namespace {

constexpr const char* kStep = "vug:step";
constexpr const char* kKeep = "vug:keep";
constexpr const char* kExact = "exact";

/// The meshes of level sets among what the cells stand on, one for each level set.
std::vector<MeshPtr> solid_grounds(const CellsPlan& plan) {
  std::vector<MeshPtr> out;
  std::set<VolumePtr> known;
  for (const MeshPtr& mesh : plan.on)
    if (mesh->volume && known.insert(mesh->volume).second) out.push_back(mesh);
  return out;
}

/// Vertices without triangles: the places on the surface that the band's voxels belong to.
mesh::Mesh feet(const MeshPlan& ground, const volume::LevelSet& level_set) {
  volume::Band band = volume::band(level_set);
  mesh::Mesh out;
  out.positions = std::move(band.foot);
  out.normals = std::move(band.normal);
  if (ground.paint) add_colors(out, ground.paint, volume::samples(level_set).get());
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

/// Names of columns of a table.
void write_names(mesh::Output& out, const std::string& name, const std::vector<float>&) {
  out.text(",").text(name);
}
void write_names(mesh::Output& out, const std::string& name, const std::vector<int32_t>&) {
  out.text(",").text(name);
}
void write_names(mesh::Output& out, const std::string& name, const std::vector<Vec3f>&) {
  for (const char* part : {"_x", "_y", "_z"}) out.text(",").text(name).text(part);
}

template <class T>
void write_value(mesh::Output& out, const T& value) {
  if constexpr (std::is_same_v<T, Vec3f>)
    out.text(",").number(value.x).text(",").number(value.y).text(",").number(value.z);
  else
    out.text(",").number(value);
}

}  // namespace

std::vector<CellsPtr> declared_cells(const Shot& shot) {
  std::vector<CellsPtr> out;
  for (const MeshPtr& mesh : shot.meshes)
    if (mesh->cells && std::find(out.begin(), out.end(), mesh->cells) == out.end())
      out.push_back(mesh->cells);
  return out;
}

volume::Grid cell_points(const CellsPlan& plan, const Skin& skin, cells::Keep keep) {
  volume::Points points = cells::as_points(skin.simulation, keep);
  const bool exact = keep == cells::Keep::exact;
  if (plan.half && !exact)
    for (volume::PointAttribute& each : points.attributes) each.half = true;
  return volume::point_grid(points, cells::voxel_of_points(skin.network()))
      .named(plan.name)
      .with({{kStep, int64_t{skin.simulation.step()}},
             {kKeep, std::string(exact ? kExact : "shown")}});
}

std::vector<volume::Grid> cell_grids(Builder& builder, const CellsPtr& plan) {
  constexpr double kBytes = 200;  // what a voxel takes while its values are found
  std::vector<volume::Grid> out;
  const SkinPtr skin = builder.skin(plan);
  const std::vector<MeshPtr> grounds = solid_grounds(*plan);
  for (const MeshPtr& ground : grounds) {
    const volume::LevelSet& level_set = builder.level_set(ground->volume);
    require_memory(kBytes * static_cast<double>(level_set.statistics().active_voxels),
                   builder.room(), fmt::format("the grids of '{}'", plan->name),
                   "leave grids out of its files, use larger voxels");
    mesh::Mesh places = feet(*ground, level_set);
    cells::onto_mesh(skin->simulation, places, {}, builder.progress());
    const std::string name =
        grounds.size() == 1 ? plan->name : fmt::format("{}_{}", plan->name, ground->volume->name);
    for (const mesh::Attribute& each : places.attributes)
      out.push_back(grid_of(each, level_set)
                        .named(fmt::format("{}_{}", name, each.name))
                        .stored_as_half(plan->half));
  }
  return out;
}

void write_table(const std::filesystem::path& file, const Skin& skin) {
  const volume::Points points = cells::as_points(skin.simulation);
  AtomicFile target(file);
  std::ofstream to(target.path(), std::ios::binary);
  const mesh::ByteSink sink = [&](std::string_view bytes) {
    to.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  };
  mesh::Output out(sink);
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
    out.text(",").text(cells::name_of(skin.simulation.states()[i])).text("\n");
  }
  out.finish();
  to.close();
  if (!to)
    throw Error(ErrorCode::io,
                fmt::format("cannot write '{}': {}", file.string(), std::strerror(errno)));
  target.commit();
}

void read_cells(const volume::Grid& grid, cells::Simulation& simulation) {
  const volume::Metadata metadata = grid.metadata();
  const auto step = metadata.find(kStep);
  const auto* done = step == metadata.end() ? nullptr : std::get_if<int64_t>(&step->second);
  const auto keep = metadata.find(kKeep);
  const bool exact = keep != metadata.end() && keep->second == volume::MetaValue(kExact);
  const volume::Points points = volume::points(grid);
  // A step of 16 bits along each axis, and the rounding of floats.
  float far = 0;
  for (const Vec3f& p : points.position)
    far = std::max({far, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  const double apart = 2 * (grid.voxel_size().x / 65535 + static_cast<double>(far) * 0x1p-23);
  cells::restore(simulation, points, done ? static_cast<int>(*done) : 0,
                 exact ? cells::Keep::exact : cells::Keep::shown, apart);
}

std::optional<volume::Grid> points_from(const CellsPlan& plan) {
  if (plan.from.empty()) return std::nullopt;
  try {
    std::optional<volume::Grid> found;
    for (const volume::Grid& grid : volume::read(plan.from))
      if (volume::is_points(grid) && (!found || grid.name() == plan.name)) found = grid;
    if (found) return found;
    throw Error(ErrorCode::bad_input, fmt::format("'{}' holds no points", plan.from.string()), {},
                "vug build writes them of cells whose files are not told to leave them out");
  } catch (const Error& error) {
    throw blamed_on(plan.where, error);
  }
}

}  // namespace vug::session
