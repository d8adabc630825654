#include <vug/field/field.h>

#include <cmath>
#include <unordered_set>

namespace vug::field {

Gradient Field::gradient(const Vec3d& p) const {
  const Dual<double> d = node_->eval(seeded(point(p)));
  return {d.v, {d.dx, d.dy, d.dz}};
}

Interval Field::interval(const Box3d& box) const {
  const Interval natural = node_->eval(region(box));
  const Interval lipschitz = node_->restrict_to({box.center(), 0.5 * box.size().length()}).range;
  // A natural bound can be NaN-free but infinite, or undefined for sampled data: then the other
  // holds.
  if (std::isnan(natural.lo) || std::isnan(natural.hi)) return lipschitz;
  if (std::isnan(lipschitz.lo) || std::isnan(lipschitz.hi)) return natural;
  return meet(natural, lipschitz);
}

Field::Part Field::restricted(const Ball& ball) const {
  Restriction r = node_->restrict_to(ball);
  return {r.node ? Field(std::move(r.node)) : *this, r.range};
}

namespace {

void print(const Node& node, int depth, std::string& out) {
  out.append(2 * static_cast<size_t>(depth), ' ').append(node.name()).push_back('\n');
  for (const NodePtr& child : node.children()) print(*child, depth + 1, out);
}

void visit(const NodePtr& node, std::unordered_set<const Node*>& seen) {
  if (!seen.insert(node.get()).second) return;
  for (const NodePtr& child : node->children()) visit(child, seen);
}

}  // namespace

std::string to_string(const Field& field) {
  std::string out;
  print(*field.node(), 0, out);
  return out;
}

size_t node_count(const Field& field) {
  std::unordered_set<const Node*> seen;
  visit(field.node(), seen);
  return seen.size();
}

}  // namespace vug::field
