// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/mesh/distance.h>
#include <vug/mesh/topology.h>
#include <vug/network/survey_space.h>
#include <vug/passages/wall_scraps.h>

#include <algorithm>

namespace vug::passages {
namespace {

/// For each component of the surface, whether it is near a station.
std::vector<char> surveyed_components(const mesh::Mesh& surface, const survey::Survey& survey,
                                      const Vec3d& origin, const std::vector<uint32_t>& component) {
  std::vector<char> out(*std::max_element(component.begin(), component.end()) + 1, 0);
  const mesh::MeshDistance distance(surface);
  for (const survey::Station& station : survey.stations) {
    if (station.surface && !station.underground) continue;
    const Vec3d place = network::to_scene(station.position - origin);
    out[component[distance.closest(place).triangle]] = 1;
  }
  return out;
}

}  // namespace

std::vector<survey::Scrap> wall_scraps(const mesh::Mesh& surface, const survey::Survey& survey,
                                       const Vec3d& origin) {
  if (surface.triangles.empty())
    throw Error(ErrorCode::bad_input, "the surface around the survey is empty", {},
                "choose a volume with walls, or smaller voxels");
  const std::vector<uint32_t> component = mesh::face_components(surface, mesh::find_edges(surface));
  const std::vector<char> surveyed = surveyed_components(surface, survey, origin, component);
  std::vector<survey::Scrap> scraps(surveyed.size());
  // A vertex at which components touch belongs to each of them.
  std::vector<int> index(surface.positions.size());
  std::vector<uint32_t> owner(surface.positions.size(), ~uint32_t{0});
  std::vector<std::vector<uint32_t>> triangles(surveyed.size());
  for (size_t t = 0; t < component.size(); ++t)
    if (surveyed[component[t]]) triangles[component[t]].push_back(static_cast<uint32_t>(t));
  for (uint32_t c = 0; c < triangles.size(); ++c)
    for (const uint32_t t : triangles[c]) {
      std::array<int, 3> corners{};
      for (size_t k = 0; k < 3; ++k) {
        const uint32_t vertex = surface.triangles[t][k];
        if (owner[vertex] != c) {
          owner[vertex] = c;
          index[vertex] = static_cast<int>(scraps[c].points.size());
          scraps[c].points.push_back(network::to_survey(Vec3d(surface.positions[vertex])) + origin);
        }
        corners[k] = index[vertex];
      }
      scraps[c].triangles.push_back(corners);
    }
  std::erase_if(scraps, [](const survey::Scrap& scrap) { return scrap.triangles.empty(); });
  return scraps;
}

}  // namespace vug::passages
