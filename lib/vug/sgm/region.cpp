// SPDX-License-Identifier: Apache-2.0
#include <vug/sgm/region.h>

#include <vug/field/boolean.h>
#include <vug/field/material_source.h>
#include <vug/field/primitive.h>
#include <vug/field/translated.h>

#include <algorithm>

namespace vug::sgm {
namespace {

using field::constant;
using field::dot;
using field::Exactness;
using field::Field;
using field::length;
using field::max;
using field::NodePtr;
using field::Pack;
using field::point;
using field::Point;
using field::Restriction;
using field::Scratch;
using field::Traits;

/// Far away both terms grow, so their mean does; a blend reduces it by at most its depth.
Traits morph_traits(const Traits& base, const Traits& shape, double amount, double depth) {
  return {std::max(base.lipschitz, (1 - amount) * base.lipschitz + amount * shape.lipschitz),
          std::max({base.exactness, shape.exactness, Exactness::bound}),
          united(base.bounds_below(depth), shape.bounds_below(depth)),
          std::min(base.growth_rate(), shape.growth_rate())};
}

/// A single node instead of a morph of the base with a union, because that would evaluate the base
/// twice, and after n morphs 2^n times.
class LocalMorph final : public field::EvaluationModes<LocalMorph>, public field::MaterialSource {
 public:
  LocalMorph(Traits traits, NodePtr base, NodePtr shape, double amount, field::Blend blend)
      : EvaluationModes(std::move(traits)),
        base_(std::move(base)),
        shape_(std::move(shape)),
        amount_(amount),
        blend_(blend) {}

  template <class T>
  T at(const Point<T>& p) const {
    return mixed(base_->eval(p), shape_->eval(p));
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    Scratch::Frame frame(scratch);
    T* other = frame.template take<T>(static_cast<size_t>(count));
    base_->eval(points, count, out, scratch);
    shape_->eval(points, count, other, scratch);
    for (int i = 0; i < count; ++i) out[i] = mixed(out[i], other[i]);
  }
  Restriction restrict_to(const field::Ball& ball) const override {
    const Restriction base = base_->restrict_to(ball), shape = shape_->restrict_to(ball);
    if (shape.range.lo >= base.range.hi + blend_.radius)  // The shape cannot matter here.
      return {base.range, base.node ? base.node : base_};
    Restriction out;
    out.range =
        intersection(mixed(base.range, shape.range), centre_form(eval(point(ball.centre)), ball));
    if (base.node || shape.node)
      out.node = std::make_shared<LocalMorph>(traits(), base.node ? base.node : base_,
                                              shape.node ? shape.node : shape_, amount_, blend_);
    return out;
  }
  NodePtr translated(const Vec3d& by) const override {
    return std::make_shared<LocalMorph>(traits().translated(by), field::translated(base_, by),
                                        field::translated(shape_, by), amount_, blend_);
  }
  std::string name() const override { return "local morph"; }
  std::vector<NodePtr> children() const override { return {base_, shape_}; }

  field::MaterialSample sample_materials(const Vec3d& p) const override {
    const field::MaterialSample base = field::sample_materials(*base_, p),
                                shape = field::sample_materials(*shape_, p);
    return {mixed(base.value, shape.value),
            field::mixed(base.mix, shape.mix, amount_ * blend_.share(base.value, shape.value))};
  }
  field::Coat coat(const Vec3d& p) const override { return field::coat_at(*base_, p); }
  std::optional<Field> material_mean(const field::MaterialNumber& number) const override {
    const std::optional<Field> base = field::material_mean(Field(base_), number),
                               shape = field::material_mean(Field(shape_), number);
    if (!base || !shape) return base ? base : shape;
    const Field nearer =
        field::contact_mean({{Field(base_), *base}, {Field(shape_), *shape}}, 1, number);
    return field::morph(*base, nearer, amount_);
  }
  std::vector<NodePtr> material_operands() const override { return children(); }

 protected:
  void add_to(Digester& digester) const override { digester(base_, shape_, amount_, blend_); }

 private:
  /// base + a (min(base, shape) - base): bit-identical to the base where it is smaller. In the
  /// second form both factors are monotone in base and shape, so intervals stay tight.
  template <class T>
  T mixed(const T& base, const T& shape) const {
    const T nearer = blend_.smin(base, shape);
    if constexpr (std::is_same_v<T, Interval>)
      return base * Interval(1 - amount_) + nearer * Interval(amount_);
    else
      return base + (nearer - base) * T(amount_);
  }

  NodePtr base_, shape_;
  double amount_;
  field::Blend blend_;
};

/// Half a ball: on the side of `direction` of a plane through `centre`.
struct HalfBall {
  Vec3d centre, direction;
  double radius;

  template <class T>
  T distance(const Point<T>& p) const {
    const Point<T> d = p - constant<T>(centre);
    return max(length(d) - T(radius), -dot(d, constant<T>(direction)));
  }
  Box3d bounds() const { return {centre - Vec3d(radius), centre + Vec3d(radius)}; }
  Exactness exactness() const { return Exactness::bound; }
};

}  // namespace

Field local_morph(const Field& base, const Field& shape, double amount, const field::Blend& blend) {
  if (!(amount >= 0 && amount <= 1))
    throw Error(ErrorCode::bad_input, "a morph's amount must be between 0 and 1");
  if (amount == 0) return base;
  if (amount == 1) return field::unite({base, shape}, blend);
  Traits traits =
      morph_traits(base.node()->traits(), shape.node()->traits(), amount, blend.depth());
  return Field(
      std::make_shared<LocalMorph>(std::move(traits), base.node(), shape.node(), amount, blend));
}

Field local_intersection(const Field& base, const Field& shape, const Vec3d& centre,
                         const Vec3d& direction, double radius, const field::Blend& blend) {
  const Field end(std::make_shared<field::PrimitiveNode<HalfBall>>(
      "half ball", HalfBall{centre, direction, radius}));
  return field::intersect({base, field::unite({shape, field::complement(end)})}, blend);
}

}  // namespace vug::sgm
