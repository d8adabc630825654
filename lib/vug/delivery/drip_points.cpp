// SPDX-License-Identifier: Apache-2.0
#include <vug/delivery/drip_points.h>

namespace vug::delivery {
namespace {

constexpr const char* kNodes[] = {"seep", "confluence", "bend", "drop", "landing", "pool", "sink"};
constexpr const char* kEdges[] = {"ceiling_film", "wall_film", "fall", "floor_film", "overflow"};
/// Single precision has no place for discharges in m3/s.
constexpr double kCubicMillimetres = 1e9;

}  // namespace

const char* kind_name(drips::NodeKind kind) { return kNodes[static_cast<size_t>(kind)]; }
const char* kind_name(drips::EdgeKind kind) { return kEdges[static_cast<size_t>(kind)]; }

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
  for (size_t kind = 0; kind < std::size(kNodes); ++kind) {
    std::vector<uint8_t> members;
    for (const int32_t each : kinds) members.push_back(each == static_cast<int32_t>(kind));
    points.groups.push_back({kNodes[kind], std::move(members)});
  }
  points.attributes = {{"N", std::move(normals)},       {"id", std::move(ids)},
                       {"kind", std::move(kinds)},      {"discharge", std::move(discharge)},
                       {"calcium", std::move(calcium)}, {"temperature", std::move(temperature)},
                       {"age", std::move(age)}};
  return points;
}

}  // namespace vug::delivery
