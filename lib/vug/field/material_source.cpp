// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/field/material_source.h>

#include <algorithm>
#include <map>
#include <unordered_set>

namespace vug::field {
namespace {

const MaterialSource* source_of(const Node& node) {
  return dynamic_cast<const MaterialSource*>(&node);
}

}  // namespace

MaterialSample sample_materials(const Node& node, const Vec3d& p) {
  if (const MaterialSource* source = source_of(node)) return source->sample_materials(p);
  MaterialSample out{node.eval(point(p)), {}};
  if (const std::vector<NodePtr> children = node.children(); !children.empty())
    out.mix = sample_materials(*children.front(), p).mix;
  return out;
}

double hardness_at(const Field& field, const Vec3d& p) {
  return sample_materials(*field.node(), p).mix.hardness();
}

Coat coat_at(const Node& node, const Vec3d& p) {
  if (const MaterialSource* source = source_of(node)) return source->coat(p);
  const std::vector<NodePtr> children = node.children();
  return children.empty() ? Coat() : coat_at(*children.front(), p);
}

std::vector<RockMaterialPtr> materials_of(const Field& field) {
  std::map<std::string, RockMaterialPtr> by_name;
  std::vector<NodePtr> pending{field.node()};
  std::unordered_set<const Node*> seen;
  while (!pending.empty()) {
    const NodePtr node = std::move(pending.back());
    pending.pop_back();
    if (!seen.insert(node.get()).second) continue;
    const MaterialSource* source = source_of(*node);
    if (source)
      for (const RockMaterialPtr& each : source->assigned()) by_name.emplace(each->name, each);
    std::vector<NodePtr> next = source ? source->material_operands() : node->children();
    if (!source && next.size() > 1) next.resize(1);
    for (NodePtr& each : next) pending.push_back(std::move(each));
  }
  std::vector<RockMaterialPtr> out;
  for (const auto& [name, material] : by_name) out.push_back(material);
  return out;
}

std::vector<MaterialMix> materials_at(const Field& field, const std::vector<Vec3f>& points) {
  std::vector<MaterialMix> out(points.size());
  constexpr size_t kChunk = 256;
  parallel_for((points.size() + kChunk - 1) / kChunk, [&](size_t chunk) {
    const size_t end = std::min(points.size(), (chunk + 1) * kChunk);
    for (size_t i = chunk * kChunk; i < end; ++i)
      out[i] = sample_materials(*field.node(), Vec3d(points[i])).mix;
  });
  return out;
}

}  // namespace vug::field
