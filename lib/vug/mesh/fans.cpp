// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/fans.h>

namespace vug::mesh {

Fans::Fans(const Mesh& mesh) : first_(mesh.positions.size() + 1, 0) {
  for (const Triangle& t : mesh.triangles)
    for (const uint32_t v : t) ++first_[v + 1];
  for (size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  faces_.resize(first_.back());
  std::vector<uint32_t> next(first_.begin(), first_.end() - 1);
  for (uint32_t f = 0; f < mesh.triangles.size(); ++f)
    for (const uint32_t v : mesh.triangles[f]) faces_[next[v]++] = f;
}

}  // namespace vug::mesh
