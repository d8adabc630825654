// SPDX-License-Identifier: Apache-2.0
// The node that all deformers share: it transforms the point before it evaluates the child, f(p) =
// scale * child(map(p)).
#pragma once

#include <vug/field/evaluates_below.h>
#include <vug/field/kind.h>
#include <vug/field/material_source.h>
#include <vug/field/near_materials.h>
#include <vug/field/scaled_values.h>

namespace vug::field {

/// D has
///   template <class T> Point<T> map(const Point<T>&) const   from outside to the child's space
///   Ball map(const Ball&) const                   a ball around the image of a ball
///   double scale() const                          factor on the child's value, > 0
///   Traits traits(const Traits& child) const
///   template <class S> Point<S> pull_back(const Point<S>& gradient) const
///     optional, for maps with a constant derivative: transforms a gradient of the child outwards
///   NodePtr translated(const NodePtr& child, const Vec3d& by) const
///     optional: see Node::translated
template <class D>
class DeformerNode final : public EvaluationModes<DeformerNode<D>>,
                           public LimitModes<DeformerNode<D>>,
                           public MaterialSource,
                           public NearMaterials {
 public:
  DeformerNode(std::string name, D deformer, NodePtr child)
      : EvaluationModes<DeformerNode<D>>(deformer.traits(child->traits())),
        name_(std::move(name)),
        deformer_(std::move(deformer)),
        child_(std::move(child)),
        below_(evaluates_below(*child_)) {}

  template <class T>
  T at(const Point<T>& p) const {
    return child_->eval(deformer_.map(p)) * T(deformer_.scale());
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    fill_by([&](const Point<Pack>* moved) { child_->eval(moved, count, out, scratch); }, points,
            count, out, scratch);
  }
  template <class T>
  void fill_below(const Point<Pack>* points, const Pack* limits, int count, T* out,
                  Scratch& scratch) const {
    if (!below_) return fill(points, count, out, scratch);
    Scratch::Frame frame(scratch);
    const double scale = deformer_.scale();
    if (scale != 1) {
      Pack* scaled = frame.template take<Pack>(static_cast<size_t>(count));
      for (int i = 0; i < count; ++i) scaled[i] = limit_for(limits[i] * Pack(1 / scale), 0);
      limits = scaled;
    }
    fill_by(
        [&](const Point<Pack>* moved) { below_->eval_below(moved, limits, count, out, scratch); },
        points, count, out, scratch);
  }
  bool skips() const override { return below_ != nullptr; }
  const Node* only_child() const override { return child_.get(); }

  Restriction restrict_to(const Ball& ball) const override {
    const Restriction inner = child_->restrict_to(deformer_.map(ball));
    const double scale = deformer_.scale();
    Restriction out;
    out.range = Interval(inner.range.lo * scale, inner.range.hi * scale);
    if (inner.node) out.node = std::make_shared<DeformerNode>(name_, deformer_, inner.node);
    return out;
  }
  NodePtr translated(const Vec3d& by) const override {
    if constexpr (requires { deformer_.translated(child_, by); })
      return deformer_.translated(child_, by);
    else
      return nullptr;
  }
  std::string name() const override { return name_; }
  std::vector<NodePtr> children() const override { return {child_}; }
  const D& deformer() const { return deformer_; }

  MaterialSample sample_materials(const Vec3d& p) const override {
    MaterialSample out = field::sample_materials(*child_, inside(p));
    out.value *= deformer_.scale();
    return out;
  }
  NearMixes mixes_near(const NearPoints& points) const override {
    std::vector<Vec3d> moved;
    moved.reserve(points.size());
    for (const Vec3d& p : points.at) moved.push_back(inside(p));
    return field::mixes_near(*child_, NearPoints(std::move(moved)));
  }
  Coat coat(const Vec3d& p) const override { return coat_at(*child_, inside(p)); }
  std::optional<Field> material_mean(const MaterialNumber& number) const override {
    const std::optional<Field> mean = field::material_mean(Field(child_), number);
    if (!mean) return mean;
    return scaled_values(Field(std::make_shared<DeformerNode>(name_, deformer_, mean->node())),
                         1 / deformer_.scale());
  }
  std::vector<NodePtr> material_operands() const override { return {child_}; }

 protected:
  void add_to(Digester& digester) const override { digester(name_, deformer_, child_); }

 private:
  Vec3d inside(const Vec3d& p) const { return vector(deformer_.map(point(p))); }
  static constexpr bool kConstantDerivative = requires(const D& deformer, const Point<Pack>& g) {
    deformer.pull_back(g);
  };

  /// `eval_child` fills `out` with the child's values at moved points.
  template <class Eval, class T>
  void fill_by(const Eval& eval_child, const Point<Pack>* points, int count, T* out,
               Scratch& scratch) const {
    Scratch::Frame frame(scratch);
    const auto size = static_cast<size_t>(count);
    auto* moved = frame.template take<Point<Pack>>(size);
    constexpr bool kValues = std::is_same_v<T, Pack>;
    if constexpr (kValues || kConstantDerivative) {
      for (int i = 0; i < count; ++i) moved[i] = deformer_.map(points[i]);
      eval_child(moved);
      if constexpr (!kValues)
        for (int i = 0; i < count; ++i) {
          const Point<Pack> outside = deformer_.pull_back(gradient_of(out[i]));
          out[i] = {out[i].v, outside.x, outside.y, outside.z};
        }
    } else {
      auto* mapped = frame.template take<Point<T>>(size);
      for (int i = 0; i < count; ++i) {
        mapped[i] = deformer_.map(seeded(points[i]));
        moved[i] = {mapped[i].x.v, mapped[i].y.v, mapped[i].z.v};
      }
      eval_child(moved);
      for (int i = 0; i < count; ++i)
        out[i] = differentiated(out[i].v, gradient_of(out[i]), mapped[i]);
    }
    const double scale = deformer_.scale();
    if (scale != 1)
      for (int i = 0; i < count; ++i) out[i] = out[i] * T(scale);
  }

  std::string name_;
  D deformer_;
  NodePtr child_;
  const EvaluatesBelow* below_;  // The child, or null.
};

}  // namespace vug::field
