#include <vug/base/atomic_file.h>
#include <vug/mesh/format.h>
#include <vug/session/write.h>
#include <vug/volume/fog.h>
#include <vug/volume/io.h>

#include <fmt/format.h>

namespace vug::session {

std::vector<std::filesystem::path> product_paths(const Shot& shot,
                                                 const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  if (!shot.volumes.empty()) paths.push_back(folder / (shot.name + ".vdb"));
  const std::vector<MeshPtr> meshes = declared_meshes(shot);
  for (const MeshPtr& plan : meshes) {
    const bool plain = meshes.size() == 1 || plan->name == shot.name;
    const std::string stem = plain ? shot.name : fmt::format("{}_{}", shot.name, plan->name);
    paths.push_back(folder / fmt::format("{}.{}", stem, plan->format));
  }
  return paths;
}

std::vector<std::filesystem::path> write_products(Builder& builder,
                                                  const std::filesystem::path& folder) {
  const Shot& shot = builder.shot();
  const std::vector<std::filesystem::path> paths = product_paths(shot, folder);
  for (const auto& path : paths) require_writable(path);
  auto path = paths.begin();
  for (const MeshPtr& plan : declared_meshes(shot)) builder.require_room(plan);
  if (!shot.volumes.empty()) {
    volume::WriteOptions options;
    options.metadata = {{"vug:recipe", shot.recipe}, {"vug:seed", static_cast<int64_t>(shot.seed)}};
    std::vector<volume::Grid> grids;
    for (const VolumePtr& plan : shot.volumes) {
      const volume::LevelSet& level_set = builder.level_set(plan);
      const volume::Grid grid = plan->fog ? volume::fog(level_set) : volume::Grid(level_set);
      grids.push_back(grid.named(plan->name).stored_as_half(plan->half));
    }
    volume::write(*path++, grids, options);
  }
  for (const MeshPtr& plan : declared_meshes(shot)) mesh::write_mesh(*builder.mesh(plan), *path++);
  return paths;
}

}  // namespace vug::session
