// SPDX-License-Identifier: Apache-2.0
#include <vug/field/field.h>
#include <vug/field/near_surface.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace vug::field {

namespace {

/// Children before parents, each node once; without recursion, because an expression may be deep.
std::vector<const Node*> children_first(const NodePtr& root) {
  struct Step {
    NodePtr node;
    bool left;
  };
  std::vector<Step> open{{root, false}};
  std::vector<const Node*> order;
  std::unordered_set<const Node*> seen;
  while (!open.empty()) {
    const Step step = open.back();
    open.pop_back();
    if (step.left) {
      order.push_back(step.node.get());
    } else if (seen.insert(step.node.get()).second) {
      open.push_back({step.node, true});
      for (const NodePtr& child : step.node->children()) open.push_back({child, false});
    }
  }
  return order;
}

}  // namespace

Digest Field::digest() const {
  for (const Node* node : children_first(node_)) node->digest();  // No deep recursion.
  return node_->digest();
}

Gradient Field::gradient(const Vec3d& p) const {
  const Dual<double> d = node_->eval(seeded(point(p)));
  return {d.v, {d.dx, d.dy, d.dz}};
}

Interval Field::interval(const Box3d& box) const {
  const Interval natural = node_->eval(region(box));
  const Interval lipschitz = node_->restrict_to({box.center(), 0.5 * box.size().length()}).range;
  // Interval arithmetic can give infinite bounds, or NaN for sampled data; then the Lipschitz bound
  // applies.
  if (std::isnan(natural.lo) || std::isnan(natural.hi)) return lipschitz;
  if (std::isnan(lipschitz.lo) || std::isnan(lipschitz.hi)) return natural;
  return intersection(natural, lipschitz);
}

Field::RestrictedField Field::restricted(const Ball& ball) const {
  Restriction r = node_->restrict_to(ball);
  return {r.node ? Field(std::move(r.node)) : *this, r.range};
}

Field::RestrictedField Field::restricted_near(const Ball& ball, double limit) const {
  const auto* near = dynamic_cast<const NearSurface*>(node_.get());
  if (!near) return restricted(ball);
  Restriction r = near->restrict_near(ball, limit);
  return {r.node ? Field(std::move(r.node)) : *this, r.range};
}

namespace {

void print(const Node& node, int depth, std::string& out) {
  out.append(2 * static_cast<size_t>(depth), ' ').append(node.name()).push_back('\n');
  for (const NodePtr& child : node.children()) print(*child, depth + 1, out);
}

}  // namespace

std::string to_string(const Field& field) {
  std::string out;
  print(*field.node(), 0, out);
  return out;
}

size_t node_count(const Field& field) { return children_first(field.node()).size(); }

EvaluationCost extent(const Field& field) {
  std::unordered_map<const Node*, EvaluationCost> known;
  for (const Node* node : children_first(field.node())) {
    EvaluationCost out;
    for (const NodePtr& child : node->children()) {
      const EvaluationCost& part = known.at(child.get());
      out.visits += part.visits;
      out.depth = std::max(out.depth, part.depth + 1);
    }
    known.emplace(node, out);
  }
  return known.at(field.node().get());
}

}  // namespace vug::field
