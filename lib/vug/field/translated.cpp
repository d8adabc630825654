// SPDX-License-Identifier: Apache-2.0
#include <vug/field/affine.h>
#include <vug/field/evaluates_below.h>
#include <vug/field/near_surface.h>
#include <vug/field/translated.h>
#include <vug/field/translation.h>

#include <utility>

namespace vug::field {
namespace {

/// A child at moved points; Derived adds the interface of the child that DeformerNode would hide.
template <class Derived>
class TranslatedNode : public EvaluationModes<Derived> {
 public:
  TranslatedNode(const Vec3d& by, NodePtr child)
      : EvaluationModes<Derived>(child->traits().translated(by)),
        move_{by},
        child_(std::move(child)) {}

  template <class T>
  T at(const Point<T>& p) const {
    return child_->eval(move_.map(p));
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    Scratch::Frame frame(scratch);
    child_->eval(moved(points, count, frame), count, out, scratch);
  }
  Restriction restrict_to(const Ball& ball) const override {
    return outside(child_->restrict_to(move_.map(ball)));
  }
  NodePtr translated(const Vec3d& by) const override { return move_.translated(child_, by); }
  std::string name() const override { return "translate"; }
  std::vector<NodePtr> children() const override { return {child_}; }

 protected:
  void add_to(Digester& digester) const override { digester(move_, child_); }
  const Translation& move() const { return move_; }
  const Node& child() const { return *child_; }
  const Point<Pack>* moved(const Point<Pack>* points, int count, Scratch::Frame& frame) const {
    auto* out = frame.template take<Point<Pack>>(static_cast<size_t>(count));
    for (int i = 0; i < count; ++i) out[i] = move_.map(points[i]);
    return out;
  }
  Restriction outside(Restriction inner) const {
    if (inner.node) inner.node = field::translated(inner.node, move_.by);
    return inner;
  }

 private:
  Translation move_;
  NodePtr child_;
};

class TranslatedBelow final : public TranslatedNode<TranslatedBelow>, public EvaluatesBelow {
 public:
  using TranslatedNode::TranslatedNode;
  void eval_below(const Point<Pack>* points, const Pack* limits, int count, Pack* out,
                  Scratch& scratch) const override {
    Scratch::Frame frame(scratch);
    evaluate_below(child(), moved(points, count, frame), limits, count, out, scratch);
  }
  void eval_below(const Point<Pack>* points, const Pack* limits, int count, Dual<Pack>* out,
                  Scratch& scratch) const override {
    Scratch::Frame frame(scratch);
    evaluate_below(child(), moved(points, count, frame), limits, count, out, scratch);
  }
  Restriction restrict_below(const Ball& ball, double limit) const override {
    return outside(field::restrict_below(child(), move().map(ball), limit));
  }
};

class TranslatedNear final : public TranslatedNode<TranslatedNear>, public NearSurface {
 public:
  TranslatedNear(const Vec3d& by, NodePtr child, const NearSurface& near)
      : TranslatedNode(by, std::move(child)), near_(near) {}
  Restriction restrict_near(const Ball& ball, double limit) const override {
    return outside(near_.restrict_near(move().map(ball), limit));
  }
  BlockRange first_order(const LatticeBlock& block, double limit, const FirstOrderRuns& out,
                         Scratch& scratch) const override {
    return near_.first_order({block.origin - move().by, block.step}, limit, out, scratch);
  }

 private:
  const NearSurface& near_;  // The child.
};

}  // namespace

NodePtr Translation::translated(const NodePtr& child, const Vec3d& more) const {
  return field::translated(child, by + more);
}

NodePtr translated(const NodePtr& node, const Vec3d& by) {
  if (by == Vec3d(0)) return node;
  if (NodePtr moved = node->translated(by)) return moved;
  const auto* below = interface_of<EvaluatesBelow>(*node);
  if (below && !below->only_child()) return std::make_shared<TranslatedBelow>(by, node);
  if (const auto* near = interface_of<NearSurface>(*node))
    return std::make_shared<TranslatedNear>(by, node, *near);
  return transformed(Field(node), Transform::translation(by)).node();
}

Field translated(const Field& field, const Vec3d& by) {
  return Field(translated(field.node(), by));
}

}  // namespace vug::field
