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

Mesh with_attributes_of(const Mesh& mesh) {
  Mesh out;
  for (const Attribute& each : mesh.attributes)
    out.attributes.push_back({each.name, each.arity, {}});
  return out;
}

void append_vertex(const Mesh& from, uint32_t vertex, Mesh& to) {
  to.positions.push_back(from.positions[vertex]);
  if (!from.normals.empty()) to.normals.push_back(from.normals[vertex]);
  for (size_t i = 0; i < from.attributes.size(); ++i) {
    const Attribute& own = from.attributes[i];
    const auto begin = own.values.begin() + static_cast<int64_t>(vertex) * own.arity;
    to.attributes[i].values.insert(to.attributes[i].values.end(), begin, begin + own.arity);
  }
}

Mesh without_unused_vertices(const Mesh& mesh) {
  std::vector<char> used(mesh.positions.size(), 0);
  for (const Triangle& t : mesh.triangles)
    for (const uint32_t corner : t) used[corner] = 1;
  std::vector<uint32_t> target(mesh.positions.size(), 0);
  Mesh kept = with_attributes_of(mesh);
  for (uint32_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    target[v] = static_cast<uint32_t>(kept.positions.size());
    append_vertex(mesh, v, kept);
  }
  kept.triangles = mesh.triangles;
  for (Triangle& t : kept.triangles)
    for (uint32_t& corner : t) corner = target[corner];
  return kept;
}

}  // namespace vug::mesh
