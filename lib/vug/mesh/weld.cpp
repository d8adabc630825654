// SPDX-License-Identifier: Apache-2.0
#include <vug/base/hash.h>
#include <vug/mesh/weld.h>

#include <algorithm>

namespace vug::mesh {

std::vector<uint32_t> first_equal(const std::vector<Vec3f>& positions) {
  constexpr uint32_t kFree = UINT32_MAX;
  size_t slots = 16;
  while (slots < 2 * positions.size()) slots *= 2;
  std::vector<uint32_t> table(slots, kFree);
  std::vector<uint32_t> first(positions.size());
  for (uint32_t i = 0; i < positions.size(); ++i) {
    const Vec3f key = positions[i] + Vec3f(0.0F);  // -0 + 0 is 0.
    size_t slot = vug::digest(&key, sizeof key).low & (slots - 1);
    while (table[slot] != kFree && positions[table[slot]] != key) slot = (slot + 1) & (slots - 1);
    if (table[slot] == kFree) table[slot] = i;
    first[i] = table[slot];
  }
  return first;
}

Mesh welded(const Mesh& mesh) {
  const std::vector<uint32_t> first = first_equal(mesh.positions);
  Mesh joined = mesh;
  joined.triangles.clear();
  for (Triangle t : mesh.triangles) {
    for (uint32_t& corner : t) corner = first[corner];
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) joined.triangles.push_back(t);
  }
  return without_unused_vertices(joined);
}

Mesh without_unused_vertices(const Mesh& mesh) {
  std::vector<char> used(mesh.positions.size(), 0);
  for (const Triangle& t : mesh.triangles)
    for (const uint32_t corner : t) used[corner] = 1;
  std::vector<uint32_t> target(mesh.positions.size(), 0);
  Mesh kept;
  for (const Attribute& attribute : mesh.attributes)
    kept.attributes.push_back({attribute.name, attribute.arity, {}});
  for (uint32_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    target[v] = static_cast<uint32_t>(kept.positions.size());
    kept.positions.push_back(mesh.positions[v]);
    if (!mesh.normals.empty()) kept.normals.push_back(mesh.normals[v]);
    for (size_t i = 0; i < mesh.attributes.size(); ++i) {
      const auto from =
          mesh.attributes[i].values.begin() + static_cast<int64_t>(v) * mesh.attributes[i].arity;
      kept.attributes[i].values.insert(kept.attributes[i].values.end(), from,
                                       from + mesh.attributes[i].arity);
    }
  }
  kept.triangles = mesh.triangles;
  for (Triangle& t : kept.triangles)
    for (uint32_t& corner : t) corner = target[corner];
  return kept;
}

}  // namespace vug::mesh
