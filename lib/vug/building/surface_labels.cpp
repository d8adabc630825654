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
  const std::vector<std::string> names = shot::label_names(labels);
  const size_t first = mesh.attributes.size();
  std::vector<size_t> attribute;  // By label.
  for (const shot::SurfaceLabel& label : labels)
    attribute.push_back(
        first +
        static_cast<size_t>(std::find(names.begin(), names.end(), label.name) - names.begin()));
  for (const std::string& name : names)
    mesh.attributes.push_back({name, 1, std::vector<float>(count)});
  for (size_t i = 0; i < count; ++i) mesh.attributes[attribute[nearest[i]]].values[i] = 1;
}

}  // namespace vug::building
