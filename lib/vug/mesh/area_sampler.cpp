// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/area_sampler.h>

#include <algorithm>

namespace vug::mesh {

AreaSampler::AreaSampler(const Mesh& mesh, double least_up)
    : mesh_(mesh), cumulative_(mesh.triangles.size()) {
  double total = 0;
  for (size_t i = 0; i < cumulative_.size(); ++i) {
    const Vec3d across = double_area_vector(mesh, i);
    const double twice = across.length();
    if (least_up <= -1 || across.y > least_up * twice) total += 0.5 * twice;
    cumulative_[i] = total;
  }
}

SurfaceSample AreaSampler::sample(RandomKey key) const {
  RandomStream random(key);
  const double place = random.uniform() * area();
  const auto at = std::upper_bound(cumulative_.begin(), cumulative_.end(), place);
  SurfaceSample spot;
  spot.key = key;
  spot.triangle = static_cast<uint32_t>(
      std::min(at - cumulative_.begin(), static_cast<std::ptrdiff_t>(cumulative_.size()) - 1));
  double u = random.uniform(), v = random.uniform();
  if (u + v > 1) u = 1 - u, v = 1 - v;
  spot.u = u, spot.v = v;
  const auto [a, b, c] = corners(mesh_, spot.triangle);
  spot.position = a + (b - a) * u + (c - a) * v;
  Vec3d normal = double_area_vector(mesh_, spot.triangle);
  if (!mesh_.normals.empty()) {
    const Triangle& t = mesh_.triangles[spot.triangle];
    const Vec3d smooth = Vec3d(mesh_.normals[t[0]]) * (1 - u - v) + Vec3d(mesh_.normals[t[1]]) * u +
                         Vec3d(mesh_.normals[t[2]]) * v;
    if (smooth.length() > 1e-6) normal = smooth;
  }
  spot.normal = normal.normalized();
  return spot;
}

}  // namespace vug::mesh
