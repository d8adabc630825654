// SPDX-License-Identifier: Apache-2.0
#include <vug/base/disjoint_sets.h>
#include <vug/metrics/invalid_places.h>

#include <algorithm>
#include <map>

namespace vug::metrics {
namespace {

/// The triangles of the pairs, ascending.
std::vector<uint32_t> triangles_of(const std::vector<mesh::FacePair>& pairs) {
  std::vector<uint32_t> faces;
  for (const auto& [low, high] : pairs) faces.insert(faces.end(), {low, high});
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace

std::vector<InvalidPlace> invalid_places(const mesh::Mesh& mesh,
                                         const std::vector<mesh::FacePair>& pairs) {
  const std::vector<uint32_t> faces = triangles_of(pairs);
  const auto index = [&](uint32_t face) {
    return static_cast<uint32_t>(std::lower_bound(faces.begin(), faces.end(), face) -
                                 faces.begin());
  };
  DisjointSets<> sets(faces.size());
  for (const auto& [low, high] : pairs) sets.join(index(low), index(high));
  // Triangles of one group may intersect none of the others, but share corners with them.
  std::map<uint32_t, uint32_t> seen;  // The first triangle at each corner.
  for (uint32_t i = 0; i < faces.size(); ++i)
    for (const uint32_t v : mesh.triangles[faces[i]])
      sets.join(i, seen.try_emplace(v, i).first->second);
  std::map<uint32_t, std::pair<Box3d, size_t>> groups;
  for (uint32_t i = 0; i < faces.size(); ++i)
    for (const Vec3d& p : mesh::corners(mesh, faces[i])) groups[sets.root(i)].first.extendBy(p);
  for (const auto& [low, high] : pairs) ++groups[sets.root(index(low))].second;
  std::vector<InvalidPlace> places;
  for (const auto& [root, group] : groups) {
    const Vec3d size = group.first.size();
    places.push_back({(group.first.min + group.first.max) / 2.0, std::max({size.x, size.y, size.z}),
                      group.second});
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const auto& a, const auto& b) { return a.count > b.count; });
  return places;
}

size_t invalid_triangles(const std::vector<mesh::FacePair>& pairs) {
  return triangles_of(pairs).size();
}

}  // namespace vug::metrics
