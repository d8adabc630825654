// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/field/assigned_materials.h>
#include <vug/field/material_source.h>
#include <vug/field/near_materials.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <span>
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

std::vector<RockMaterialPtr> assigned_materials(const Field& field) {
  std::vector<RockMaterialPtr> out;
  std::vector<NodePtr> pending{field.node()};
  std::unordered_set<const Node*> seen;
  while (!pending.empty()) {
    const NodePtr node = std::move(pending.back());
    pending.pop_back();
    if (!seen.insert(node.get()).second) continue;
    const MaterialSource* source = source_of(*node);
    if (source)
      for (RockMaterialPtr& each : source->assigned()) out.push_back(std::move(each));
    std::vector<NodePtr> next = source ? source->material_operands() : node->children();
    if (!source && next.size() > 1) next.resize(1);
    for (NodePtr& each : next) pending.push_back(std::move(each));
  }
  return out;
}

std::vector<RockMaterialPtr> materials_of(const Field& field) {
  std::map<std::string, RockMaterialPtr> by_name;
  for (const RockMaterialPtr& each : assigned_materials(field)) by_name.emplace(each->name, each);
  std::vector<RockMaterialPtr> out;
  for (const auto& [name, material] : by_name) out.push_back(material);
  return out;
}

namespace {

constexpr size_t kNearPoints = 256;  // Points that are evaluated together.
/// The points of a chunk are sorted; those of level sets and meshes are near each other.
constexpr size_t kSortedPoints = 16 * kNearPoints;

/// Divides points across the longest side of the box around them until few remain.
template <class Visit>
void visit_near(const std::vector<Vec3f>& points, std::span<uint32_t> numbers, const Visit& visit) {
  if (numbers.size() <= kNearPoints) return visit(numbers);
  Box3f box;
  for (const uint32_t i : numbers) box.extendBy(points[i]);
  const auto axis = static_cast<int>(box.majorAxis());
  const size_t half = (numbers.size() / 2 + kNearPoints - 1) / kNearPoints * kNearPoints;
  std::nth_element(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(half),
                   numbers.end(),
                   [&](uint32_t a, uint32_t b) { return points[a][axis] < points[b][axis]; });
  visit_near(points, numbers.first(half), visit);
  visit_near(points, numbers.subspan(half), visit);
}

}  // namespace

std::vector<MaterialMix> materials_at(const Field& field, const std::vector<Vec3f>& points) {
  std::vector<MaterialMix> out(points.size());
  const Node& node = *field.node();
  parallel_for((points.size() + kSortedPoints - 1) / kSortedPoints, [&](size_t chunk) {
    const size_t begin = chunk * kSortedPoints;
    std::vector<uint32_t> order(std::min(points.size() - begin, kSortedPoints));
    std::iota(order.begin(), order.end(), static_cast<uint32_t>(begin));
    visit_near(points, std::span(order), [&](std::span<const uint32_t> numbers) {
      std::vector<Vec3d> at;
      for (const uint32_t i : numbers) at.emplace_back(points[i]);
      const NearPoints near(std::move(at));
      const NearMixes found = mixes_near(node, near);
      for (size_t k = 0; k < numbers.size(); ++k)
        out[numbers[k]] = found.known[k] ? found.mixes[k] : sample_materials(node, near.at[k]).mix;
    });
  });
  return out;
}

}  // namespace vug::field
