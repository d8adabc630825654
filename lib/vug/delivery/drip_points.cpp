// SPDX-License-Identifier: Apache-2.0
#include <vug/delivery/drip_points.h>

namespace vug::delivery {
namespace {

/// Single precision has no place for discharges in m3/s.
constexpr double kCubicMillimetres = 1e9;

}  // namespace

volume::Points drip_points(const drips::Graph& graph) {
  volume::Points points;
  std::vector<Vec3f> normals;
  std::vector<int32_t> ids, kinds;
  std::vector<float> discharge, calcium, temperature, age;
  for (const drips::Node& node : graph.nodes) {
    points.position.emplace_back(node.position);
    normals.emplace_back(node.normal);
    ids.push_back(static_cast<int32_t>(node.id));
    kinds.push_back(static_cast<int32_t>(node.kind));
    discharge.push_back(static_cast<float>(node.water.discharge * kCubicMillimetres));
    calcium.push_back(static_cast<float>(node.water.calcium));
    temperature.push_back(static_cast<float>(node.water.temperature));
    age.push_back(static_cast<float>(node.water.age));
  }
  for (int32_t kind = 0; kind <= static_cast<int32_t>(drips::NodeKind::sink); ++kind) {
    std::vector<uint8_t> members;
    for (const int32_t each : kinds) members.push_back(each == kind);
    points.groups.push_back(
        {drips::kind_name(static_cast<drips::NodeKind>(kind)), std::move(members)});
  }
  points.attributes = {{"N", std::move(normals)},       {"id", std::move(ids)},
                       {"kind", std::move(kinds)},      {"discharge", std::move(discharge)},
                       {"calcium", std::move(calcium)}, {"temperature", std::move(temperature)},
                       {"age", std::move(age)}};
  return points;
}

}  // namespace vug::delivery
