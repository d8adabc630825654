// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/mesh/rock_weights.h>

#include <algorithm>

namespace vug::mesh {
namespace {

constexpr std::string_view kWeightPrefix = "w_";

}  // namespace

std::string weight_attribute(std::string_view material) {
  return std::string(kWeightPrefix).append(material);
}

std::optional<std::string> material_of_attribute(std::string_view attribute) {
  if (attribute.size() <= kWeightPrefix.size() || !attribute.starts_with(kWeightPrefix))
    return std::nullopt;
  return std::string(attribute.substr(kWeightPrefix.size()));
}

std::vector<std::string> rock_materials(const Mesh& mesh) {
  std::vector<std::string> out;
  for (const Attribute& each : mesh.attributes)
    if (const auto material = material_of_attribute(each.name); material && each.arity == 1)
      out.push_back(*material);
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<int32_t> face_materials(const Mesh& mesh, const std::vector<std::string>& materials) {
  std::vector<const Attribute*> weights;
  for (const std::string& name : materials)
    weights.push_back(find_attribute(mesh, weight_attribute(name), 1));
  std::vector<int32_t> out(mesh.triangles.size(), -1);
  parallel_for(out.size(), [&](size_t face) {
    double most = 0;
    for (size_t m = 0; m < weights.size(); ++m) {
      if (!weights[m]) continue;
      double sum = 0;
      for (const uint32_t corner : mesh.triangles[face])
        sum += static_cast<double>(weights[m]->values[corner]);
      if (sum > most) most = sum, out[face] = static_cast<int32_t>(m);
    }
  });
  return out;
}

}  // namespace vug::mesh
