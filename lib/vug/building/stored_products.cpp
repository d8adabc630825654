// SPDX-License-Identifier: Apache-2.0
#include <vug/base/binary_stream.h>
#include <vug/building/stored_products.h>
#include <vug/building/write_product_file.h>
#include <vug/mesh/exact_file.h>
#include <vug/volume/exact_file.h>

#include <fstream>

namespace vug::building {

StoreUse user_store(const std::string& scene_file, Digest plugins,
                    std::function<void(const std::string&)> on_warning) {
  StoreUse out;
  out.plugins = plugins;
  if (!scene_file.empty())
    out.scene = std::filesystem::absolute(scene_file).lexically_normal().string();
  const std::filesystem::path folder = store::default_folder();
  if (!folder.empty())
    out.store = std::make_shared<store::Store>(store::StoreOptions{
        folder, store::default_max_bytes(), std::move(on_warning), store::default_remote()});
  return out;
}

void ProductFile<volume::LevelSet>::write(const std::filesystem::path& target,
                                          const volume::LevelSet& level_set) {
  volume::write_exact(target, level_set);
}

volume::LevelSet ProductFile<volume::LevelSet>::read(const std::filesystem::path& source) {
  return volume::read_exact(source);
}

void ProductFile<SurfaceMesh>::write(const std::filesystem::path& target, const SurfaceMesh& mesh) {
  write_product_file(target, [&](std::ostream& out) {
    mesh::write_exact(out, mesh.pieces.mesh);
    write_list(out, std::vector<uint64_t>{mesh.pieces.removed, mesh.small_features.size(),
                                          mesh.rock_weights.size()});
    for (const volume::SmallFeature& each : mesh.small_features) {
      write_list(out, std::vector<int>{static_cast<int>(each.kind)});
      write_list(out, std::vector<Vec3d>{each.at});
      write_list(out, each.samples);
    }
    for (const mesh::Attribute& each : mesh.rock_weights) mesh::write_exact(out, each);
  });
}

SurfaceMesh ProductFile<SurfaceMesh>::read(const std::filesystem::path& source) {
  std::ifstream in(source, std::ios::binary);
  SurfaceMesh out;
  out.pieces.mesh = mesh::read_exact_mesh(in);
  const auto counts = read_list<std::vector<uint64_t>>(in);
  out.pieces.removed = counts.at(0);
  for (uint64_t i = 0; i < counts.at(1); ++i) {
    volume::SmallFeature feature;
    feature.kind = static_cast<volume::SmallFeature::Kind>(read_list<std::vector<int>>(in).at(0));
    feature.at = read_list<std::vector<Vec3d>>(in).at(0);
    feature.samples = read_list<std::vector<Vec3i>>(in);
    out.small_features.push_back(std::move(feature));
  }
  for (uint64_t i = 0; i < counts.at(2); ++i)
    out.rock_weights.push_back(mesh::read_exact_attribute(in));
  return out;
}

void ProductFile<MeshWithCells>::write(const std::filesystem::path& target,
                                       const MeshWithCells& mesh) {
  write_product_file(target, [&](std::ostream& out) {
    mesh::write_exact(out, mesh.mesh);
    write_list(out, std::vector<uint64_t>{mesh.unfolded_vertices});
  });
}

MeshWithCells ProductFile<MeshWithCells>::read(const std::filesystem::path& source) {
  std::ifstream in(source, std::ios::binary);
  MeshWithCells out;
  out.mesh = mesh::read_exact_mesh(in);
  out.unfolded_vertices = read_list<std::vector<uint64_t>>(in).at(0);
  return out;
}

void StoredProducts::report(const store::Key& key, const std::string& name, bool reused,
                            double seconds) {
  std::optional<std::vector<std::string>> changed;
  if (use_.store)
    if (const auto before = use_.store->remember(use_.product_name(name), key))
      changed = store::changed_parts(*before, key);
  if (use_.on_product) use_.on_product({key.kind(), name, reused, seconds, std::move(changed)});
}

}  // namespace vug::building
