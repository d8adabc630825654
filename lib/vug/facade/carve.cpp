// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/blocks.h>
#include <vug/facade/carve.h>
#include <vug/field/affine.h>
#include <vug/field/boolean.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::facade {
namespace {

/// Overlap of added solids with the wall behind them, metres.
constexpr double kJoin = 0.1;

class Carver {
 public:
  explicit Carver(const Tree& tree) : tree_(tree) { element_instances(tree); }

  Carving run() {
    for (size_t i = 0; i < tree_.nodes.size(); ++i) plane(static_cast<int>(i));
    flush();
    for (size_t i = 0; i < tree_.nodes.size(); ++i)
      if (tree_.nodes[i].element) element(static_cast<int>(i));
    if (!cuts_.empty()) out_.layers.push_back({false, field::unite(std::move(cuts_))});
    if (!adds_.empty()) out_.layers.push_back({true, field::unite(std::move(adds_))});
    out_.fill = fills_.empty() ? field::empty() : field::unite(std::move(fills_));
    return std::move(out_);
  }

 private:
  /// Adds or removes the slab between a node's plane and its parent's.
  void plane(int index) {
    const Node& node = tree_.nodes[static_cast<size_t>(index)];
    const double from = node.parent < 0 ? 0 : tree_.nodes[static_cast<size_t>(node.parent)].depth;
    if (node.depth == from) return;
    const bool add = node.depth > from;
    if (add != add_) flush();
    add_ = add;
    for (const Placement& place : placements(tree_, index))
      planes_.push_back(add ? block(place(node.rect), from - kJoin, node.depth)
                            : block(place(node.rect), node.depth, from + kCutMargin));
  }
  void flush() {
    if (!planes_.empty()) out_.layers.push_back({add_, field::unite(std::move(planes_))});
    planes_.clear();
  }

  void element(int index) {
    const Node& node = tree_.nodes[static_cast<size_t>(index)];
    Solids one = solids_of(node);
    // The solids of an element are combined into one operand, so that they are evaluated together.
    const auto put = [&](std::vector<field::Field>& parts, std::vector<field::Field>& to) {
      if (parts.empty()) return;
      const field::Field whole = parts.size() == 1 ? parts[0] : field::unite(std::move(parts));
      for (const Placement& place : placements(tree_, index))
        to.push_back(field::transformed(whole, frame_of(node, place)));
    };
    put(one.cut, cuts_);
    put(one.add, adds_);
    put(one.fill, fills_);
  }

  const Tree& tree_;
  Carving out_;
  bool add_ = false;
  std::vector<field::Field> planes_, cuts_, adds_, fills_;
};

/// A field that forwards to another field and stores the carved facade.
class FacadeNode final : public field::Node {
 public:
  FacadeNode(FacadeInstance placed, field::NodePtr child)
      : Node(child->traits()), placed_(std::move(placed)), child_(std::move(child)) {}

  const FacadeInstance& placed() const { return placed_; }

  double eval(const field::Point<double>& p) const override { return child_->eval(p); }
  field::Dual<double> eval(const field::Point<field::Dual<double>>& p) const override {
    return child_->eval(p);
  }
  Interval eval(const field::Point<Interval>& p) const override { return child_->eval(p); }
  void eval(const field::Point<field::Pack>* points, int count, field::Pack* out,
            field::Scratch& scratch) const override {
    child_->eval(points, count, out, scratch);
  }
  void eval(const field::Point<field::Pack>* points, int count, field::Dual<field::Pack>* out,
            field::Scratch& scratch) const override {
    child_->eval(points, count, out, scratch);
  }
  field::Restriction restrict_to(const field::Ball& ball) const override {
    field::Restriction inner = child_->restrict_to(ball);
    if (!inner.node) inner.node = child_;
    return inner;
  }
  std::string name() const override { return "facade"; }
  std::vector<field::NodePtr> children() const override { return {child_}; }

 protected:
  void add_to(Digester& digester) const override { digester(child_); }

 private:
  FacadeInstance placed_;
  field::NodePtr child_;
};

}  // namespace

Transform FacadeFrame::transform(double width) const {
  return Transform::translation(at) * Transform::rotation({0, 1, 0}, yaw) *
         Transform::translation({-0.5 * width, 0, 0});
}

field::Field Carving::applied(field::Field wall) const {
  for (const Layer& layer : layers)
    wall = layer.add ? field::unite({wall, layer.solid}) : field::subtract(wall, {layer.solid});
  return wall;
}

Solids solids_of(const Node& node) {
  try {
    return node.element->solids(node.rect.width, node.rect.height);
  } catch (const Error& error) {
    throw Error(error.code(),
                fmt::format("{} '{}' of {:.4g} x {:.4g} m: {}", node.element->kind(), node.text,
                            node.rect.width, node.rect.height, error.what()),
                error.where(), error.hint());
  }
}

Transform frame_of(const Node& node, const Placement& place) {
  const Rect rect = place(node.rect);
  return place.mirrored != node.mirrored
             ? Transform({-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {rect.right(), rect.y, node.depth})
             : Transform::translation({rect.x, rect.y, node.depth});
}

Carving carve(const Tree& tree) { return Carver(tree).run(); }

field::Field zones(const Tree& tree, const std::vector<std::string>& kinds, double behind,
                   double before) {
  std::vector<field::Field> out;
  for (const ElementInstance& one : element_instances(tree)) {
    const Node& node = tree.nodes[static_cast<size_t>(one.node)];
    const auto called = [&](const std::string& kind) {
      return kind == node.element->kind() || kind == node.symbol;
    };
    if (std::any_of(kinds.begin(), kinds.end(), called))
      out.push_back(block(one.rect, node.depth - behind, node.depth + before));
  }
  return out.empty() ? field::empty() : field::unite(std::move(out));
}

field::Field wall(TreePtr tree, const FacadeFrame& frame, double thickness) {
  const field::Field slab = block({0, 0, tree->width, tree->height}, -thickness, 0);
  const field::Field carved =
      field::transformed(carve(*tree).applied(slab), frame.transform(tree->width));
  return with_facade({std::move(tree), frame}, carved);
}

field::Field with_facade(FacadeInstance placed, const field::Field& field) {
  return field::Field(std::make_shared<FacadeNode>(std::move(placed), field.node()));
}

std::optional<FacadeInstance> find_facade(const field::Field& field) {
  const auto* node = dynamic_cast<const FacadeNode*>(field.node().get());
  return node ? std::optional(node->placed()) : std::nullopt;
}

FacadeParams::FacadeParams() = default;

std::string FacadeParams::facade_fault() const {
  return find_facade(facade)
             ? ""
             : "'facade' must be a grammar of kind facade or the result of carve(...)";
}

FacadeInstance FacadeParams::placed() const {
  FacadeInstance out = *find_facade(facade);
  if (at) out.frame.at = *at;
  if (yaw) out.frame.yaw = *yaw;
  return out;
}

}  // namespace vug::facade
