// SPDX-License-Identifier: Apache-2.0
#include <vug/field/affine.h>
#include <vug/field/deformer.h>
#include <vug/field/placement.h>
#include <vug/field/translation.h>

namespace vug::field {
namespace {

struct Affine {
  Transform forward;  // From the child's space to the outside.
  Transform inverse;
  double stretch_in;  // Largest stretch of the inverse.
  double scale_out;   // Smallest stretch of the forward map.
  double uneven;      // Its largest stretch over the smallest: 1 for similarities.

  template <class T>
  Point<T> map(const Point<T>& p) const {
    const Vec3d &x = inverse.column(0), &y = inverse.column(1), &z = inverse.column(2);
    const Vec3d& t = inverse.origin();
    // Plain numbers: a factor without a derivative is cheaper than one with derivative 0.
    return {p.x * x.x + p.y * y.x + p.z * z.x + t.x, p.x * x.y + p.y * y.y + p.z * z.y + t.y,
            p.x * x.z + p.y * y.z + p.z * z.z + t.z};
  }
  template <class S>
  Point<S> pull_back(const Point<S>& g) const {
    auto along = [&](const Vec3d& c) { return g.x * S(c.x) + g.y * S(c.y) + g.z * S(c.z); };
    return {along(inverse.column(0)), along(inverse.column(1)), along(inverse.column(2))};
  }
  Ball map(const Ball& ball) const {
    return {inverse.point(ball.centre), ball.radius * stretch_in};
  }
  double scale() const { return scale_out; }
  /// Stretches do not depend on the position.
  NodePtr translated(const NodePtr& child, const Vec3d& by) const {
    Affine moved = *this;
    moved.forward = Transform::translation(by) * forward;
    moved.inverse = moved.forward.inverse();
    return std::make_shared<DeformerNode<Affine>>("transform", moved, child);
  }
  void add_to(Digester& digester) const {
    for (const Transform* map : {&forward, &inverse})
      digester(map->column(0), map->column(1), map->column(2), map->origin());
    digester(stretch_in, scale_out);
  }
  Traits traits(const Traits& child) const {
    Traits out = child;
    if (uneven > 1 + 1e-12) out.exactness = std::max(out.exactness, Exactness::bound);
    out.bounds = forward.box(child.bounds);
    out.growth = child.growth_rate() / uneven;
    return out;
  }
};

bool is_translation(const Transform& map) {
  return map.column(0) == Vec3d(1, 0, 0) && map.column(1) == Vec3d(0, 1, 0) &&
         map.column(2) == Vec3d(0, 0, 1);
}

/// The map of a node of one of the two kinds, or null.
template <class D>
const D* map_of(const Node& node) {
  const auto* placed = interface_of<DeformerNode<D>>(node);
  return placed ? &placed->deformer() : nullptr;
}
const Translation* as_moved(const Node& node) { return map_of<Translation>(node); }
const Affine* as_mapped(const Node& node) { return map_of<Affine>(node); }

}  // namespace

Field transformed(const Field& field, const Transform& map) {
  if (is_translation(map))
    return Field(std::make_shared<DeformerNode<Translation>>("translate", Translation{map.origin()},
                                                             field.node()));
  const Transform inverse = map.inverse();
  const double least = map.min_stretch(), greatest = map.max_stretch();
  const bool similarity = greatest <= least * (1 + 1e-12);
  // A rotation has a stretch of exactly 1, so that moving a solid does not scale its distances.
  const double scale = similarity && std::fabs(least - 1) < 1e-12 ? 1 : least;
  const Affine affine{map, inverse, inverse.max_stretch(), scale, greatest / least};
  return Field(std::make_shared<DeformerNode<Affine>>("transform", affine, field.node()));
}

std::optional<Transform> placement_of(const Node& node) {
  if (const auto* moved = as_moved(node)) return Transform::translation(moved->by);
  if (const auto* mapped = as_mapped(node)) return mapped->forward;
  return std::nullopt;
}

std::optional<Transform> inverse_placement_of(const Node& node) {
  if (const auto* moved = as_moved(node)) return Transform::translation(-moved->by);
  if (const auto* mapped = as_mapped(node)) return mapped->inverse;
  return std::nullopt;
}

}  // namespace vug::field
