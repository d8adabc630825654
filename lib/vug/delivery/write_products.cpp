// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/memory.h>
#include <vug/building/cell_points.h>
#include <vug/building/level_set_for_files.h>
#include <vug/building/rock_weights.h>
#include <vug/delivery/cells_files.h>
#include <vug/delivery/write_products.h>
#include <vug/mesh/format.h>
#include <vug/shot/queries.h>
#include <vug/volume/fog.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::delivery {

namespace {

/// Writes a file as a stage of the builder's progress.
template <class Write>
void write_file(const building::Builder& builder, const std::filesystem::path& file,
                const Write& write) {
  run_stage(builder.progress(), "writing " + file.filename().string(), [&] { write(file); });
}

/// The grids of the materials of all level sets, with the name of the volume before theirs if
/// several volumes have materials.
void add_rock_grids(building::Builder& builder, std::vector<volume::Grid>& grids) {
  std::vector<shot::VolumePtr> rocks;
  for (const shot::VolumePtr& plan : builder.shot().volumes)
    if (!plan->fog && !building::materials_of(*plan).empty()) rocks.push_back(plan);
  for (const shot::VolumePtr& plan : rocks) {
    const volume::LevelSet& level_set = builder.level_set(plan);
    const Progress::Product product(builder.progress(), plan->name);
    const std::string prefix = rocks.size() > 1 ? plan->name + "_" : "";
    for (volume::Grid& grid : run_stage(builder.progress(), "materials in the band", [&] {
           return building::rock_grids(*plan, level_set, prefix, builder.memory_budget());
         }))
      grids.push_back(std::move(grid));
  }
}

/// All volumes, the materials of their rock, and the grids of cells on them.
std::vector<volume::Grid> grids_of(building::Builder& builder) {
  std::vector<volume::Grid> grids;
  for (const shot::VolumePtr& plan : builder.shot().volumes)
    grids.push_back(volume_grid(
        *plan, building::level_set_for_files(builder, plan, shot::DistanceValues::bound)));
  add_rock_grids(builder, grids);
  for (const shot::CellsPtr& cells : shot::declared_cells(builder.shot()))
    if (cells->writes("grids"))
      for (volume::Grid& grid : cell_grids(builder, cells)) grids.push_back(std::move(grid));
  return grids;
}

}  // namespace

volume::Grid volume_grid(const shot::VolumePlan& plan, const volume::LevelSet& level_set) {
  const volume::Grid grid = plan.fog ? volume::fog(level_set) : volume::Grid(level_set);
  return grid.named(plan.name).stored_as_half(plan.half);
}

volume::WriteOptions write_options(const shot::Shot& shot) {
  volume::WriteOptions options;
  options.metadata = {{"vug:recipe", shot.recipe}, {"vug:seed", static_cast<int64_t>(shot.seed)}};
  return options;
}

mesh::Comments mesh_comments(const shot::Shot& shot) {
  mesh::Comments notes;
  notes.texts = {{"vug:recipe", shot.recipe},
                 {"vug:seed", std::to_string(shot.seed)},
                 {"vug:version", VUG_VERSION}};
  return notes;
}

void write_volumes(building::Builder& builder, const std::filesystem::path& vdb) {
  const std::vector<volume::Grid> grids = grids_of(builder);
  write_file(builder, vdb,
             [&](const auto& file) { volume::write(file, grids, write_options(builder.shot())); });
}

std::vector<std::filesystem::path> product_paths(const shot::Shot& shot,
                                                 const std::filesystem::path& folder,
                                                 const std::string& frame) {
  const std::string end = frame.empty() ? "" : "." + frame;
  std::vector<std::filesystem::path> paths;
  const auto add = [&](const std::string& stem, const std::string& extension) {
    paths.push_back(folder / fmt::format("{}{}.{}", stem, end, extension));
  };
  if (!shot.volumes.empty()) add(shot.name, "vdb");
  const std::vector<shot::MeshPtr> meshes = shot::declared_meshes(shot);
  for (const shot::MeshPtr& plan : meshes) {
    const bool plain = meshes.size() == 1 || plan->name == shot.name;
    add(plain ? shot.name : fmt::format("{}_{}", shot.name, plan->name), plan->format);
  }
  for (const shot::CellsPtr& cells : shot::declared_cells(shot))
    for (const auto& [what, extension] : {std::pair("points", "vdb"), std::pair("csv", "csv")})
      if (cells->writes(what)) add(fmt::format("{}_{}", shot.name, cells->name), extension);
  return paths;
}

std::vector<std::filesystem::path> write_products(building::Builder& builder,
                                                  const std::filesystem::path& folder,
                                                  const std::string& frame) {
  const shot::Shot& shot = builder.shot();
  const std::vector<std::filesystem::path> paths = product_paths(shot, folder, frame);
  for (const auto& path : paths) require_writable(path);
  auto path = paths.begin();
  for (const shot::MeshPtr& plan : shot::declared_meshes(shot)) builder.require_mesh_memory(plan);
  if (!shot.volumes.empty()) write_volumes(builder, *path++);
  for (const shot::MeshPtr& plan : shot::declared_meshes(shot))
    write_file(builder, *path++, [&, mesh = builder.mesh(plan)](const auto& file) {
      mesh::write_mesh(*mesh, file, mesh_comments(shot));
    });
  for (const shot::CellsPtr& cells : shot::declared_cells(shot)) {
    if (cells->writes("points")) {
      const building::CellLayerPtr layer = builder.cell_layer(cells);
      // Arrays, their order and the grid; measured with 10 million cells and eight attributes.
      constexpr double kBytes = 150;
      require_memory(kBytes * static_cast<double>(layer->network().size()), builder.memory_budget(),
                     fmt::format("the points of '{}'", cells->name),
                     "exclude points from its files");
      write_file(builder, *path++, [&](const auto& file) {
        volume::write(file, {building::cell_points(*cells, *layer)}, write_options(shot));
      });
    }
    if (cells->writes("csv"))
      write_file(builder, *path++, [&, layer = builder.cell_layer(cells)](const auto& file) {
        write_table(file, *layer);
      });
  }
  return paths;
}

}  // namespace vug::delivery
