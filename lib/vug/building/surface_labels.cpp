// SPDX-License-Identifier: Apache-2.0
#include <vug/building/surface_labels.h>
#include <vug/field/noise.h>

#include <algorithm>
#include <utility>

namespace vug::building {

void add_labels(mesh::Mesh& mesh, const std::vector<shot::SurfaceLabel>& labels) {
  if (labels.empty()) return;
  const size_t count = mesh.positions.size();
  std::vector<float> least(count);
  std::vector<size_t> nearest(count, 0);
  for (size_t k = 0; k < labels.size(); ++k) {
    std::vector<float> values = field::sample(labels[k].field, mesh.positions);
    for (size_t i = 0; i < count; ++i)
      if (k == 0 || values[i] < least[i]) {
        least[i] = values[i];
        nearest[i] = k;
      }
  }
  for (const std::string& name : shot::label_names(labels)) {
    mesh::Attribute mask{name, 1, std::vector<float>(count)};
    for (size_t i = 0; i < count; ++i) mask.values[i] = labels[nearest[i]].name == name ? 1.f : 0.f;
    mesh.attributes.push_back(std::move(mask));
  }
}

}  // namespace vug::building
