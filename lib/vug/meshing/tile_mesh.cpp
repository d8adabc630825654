// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/mesh/weld.h>
#include <vug/meshing/tile_mesh.h>

#include <algorithm>
#include <utility>

namespace vug::meshing {
namespace {

bool is_within(const LatticeKey& key, const volume::LatticeBox& box) {
  return box.intersects(Vec3i(key.cell[0], key.cell[1], key.cell[2]));
}

}  // namespace

TileMesh tile_mesh(const mesh::Mesh& surface, const LatticeKeys& keys,
                   const volume::LatticeBox& tile) {
  std::vector<size_t> own;
  std::vector<char> used(surface.positions.size(), 0);
  for (size_t face = 0; face < surface.triangles.size(); ++face) {
    if (!is_within(keys.vertices[keys.begins[face]], tile)) continue;
    own.push_back(face);
    for (const uint32_t v : surface.triangles[face]) used[v] = 1;
  }
  TileMesh out;
  out.mesh = mesh::with_attributes_of(surface);
  std::vector<uint32_t> renamed(used.size());
  for (uint32_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    renamed[v] = static_cast<uint32_t>(out.mesh.positions.size());
    mesh::append_vertex(surface, v, out.mesh);
    out.keys.vertices.push_back(keys.vertices[v]);
  }
  for (const size_t face : own) {
    const mesh::Triangle& t = surface.triangles[face];
    out.mesh.triangles.push_back({renamed[t[0]], renamed[t[1]], renamed[t[2]]});
    out.keys.begins.push_back(renamed[keys.begins[face]]);
  }
  return out;
}

mesh::Mesh joined(const std::vector<TileMesh>& tiles) {
  struct Place {
    LatticeKey key;
    uint32_t tile, vertex;
  };
  std::vector<Place> places;
  for (uint32_t tile = 0; tile < tiles.size(); ++tile)
    for (uint32_t v = 0; v < tiles[tile].keys.vertices.size(); ++v)
      places.push_back({tiles[tile].keys.vertices[v], tile, v});
  std::sort(places.begin(), places.end(),
            [](const Place& a, const Place& b) { return a.key < b.key; });
  mesh::Mesh out = tiles.empty() ? mesh::Mesh() : mesh::with_attributes_of(tiles[0].mesh);
  std::vector<std::vector<uint32_t>> renamed;
  for (const TileMesh& tile : tiles) renamed.emplace_back(tile.keys.vertices.size());
  for (size_t i = 0; i < places.size(); ++i) {
    if (i == 0 || places[i].key != places[i - 1].key)
      mesh::append_vertex(tiles[places[i].tile].mesh, places[i].vertex, out);
    renamed[places[i].tile][places[i].vertex] = static_cast<uint32_t>(out.positions.size() - 1);
  }
  // All triangles that begin at a vertex are in one tile, in their order.
  std::vector<std::pair<uint32_t, mesh::Triangle>> triangles;
  for (size_t tile = 0; tile < tiles.size(); ++tile)
    for (size_t face = 0; face < tiles[tile].mesh.triangles.size(); ++face) {
      const mesh::Triangle& t = tiles[tile].mesh.triangles[face];
      const std::vector<uint32_t>& names = renamed[tile];
      triangles.push_back(
          {names[tiles[tile].keys.begins[face]], {names[t[0]], names[t[1]], names[t[2]]}});
    }
  std::stable_sort(triangles.begin(), triangles.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  out.triangles.reserve(triangles.size());
  for (const auto& [begin, triangle] : triangles) out.triangles.push_back(triangle);
  return out;
}

void add_key_attribute(TileMesh& tile, const volume::LatticeBox& box) {
  mesh::Attribute keys{std::string(kLatticeKey), 4, {}};
  keys.values.reserve(4 * tile.keys.vertices.size());
  for (const LatticeKey& key : tile.keys.vertices) {
    for (size_t axis = 0; axis < 3; ++axis)
      keys.values.push_back(static_cast<float>(key.cell[axis] - box.min[static_cast<int>(axis)]));
    keys.values.push_back(static_cast<float>(key.number));
  }
  tile.mesh.attributes.push_back(std::move(keys));
}

LatticeKeys keys_of_attribute(const mesh::Mesh& mesh, const volume::LatticeBox& box) {
  LatticeKeys out;
  const mesh::Attribute* keys = mesh::find_attribute(mesh, kLatticeKey, 4);
  if (!keys)
    throw Error(ErrorCode::bad_input, "the mesh of a tile has no lattice_key", {},
                "delete the folder of the tiles, and build them again");
  out.vertices.reserve(mesh.positions.size());
  for (size_t i = 0; i + 3 < keys->values.size(); i += 4) {
    LatticeKey& key = out.vertices.emplace_back();
    for (size_t axis = 0; axis < 3; ++axis)
      key.cell[axis] =
          static_cast<int32_t>(keys->values[i + axis]) + box.min[static_cast<int>(axis)];
    key.number = static_cast<uint32_t>(keys->values[i + 3]);
  }
  return out;
}

}  // namespace vug::meshing
