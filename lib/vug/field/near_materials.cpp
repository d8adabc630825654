// SPDX-License-Identifier: Apache-2.0
#include <vug/field/evaluates_below.h>
#include <vug/field/material_source.h>
#include <vug/field/near_materials.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vug::field {
namespace {

/// A bound of the errors of single precision, relative to the largest coordinate: more than thirty
/// units in the last place.
constexpr double kRounding = 2e-6;

/// A bound of the errors of values. The coordinates of parts of the expression that are far away
/// have larger errors than those of the points.
double rounding_of(const Traits& traits, const Ball& ball) {
  double largest = 1 + std::fabs(ball.centre.x) + std::fabs(ball.centre.y) +
                   std::fabs(ball.centre.z) + ball.radius;
  if (!traits.bounds.isEmpty())
    for (int axis = 0; axis < 3; ++axis)
      for (const double end : {traits.bounds.min[axis], traits.bounds.max[axis]})
        if (std::isfinite(end)) largest = std::max(largest, std::fabs(end));
  return kRounding * largest * std::max(1.0, traits.lipschitz);
}

Ball ball_around(const std::vector<Vec3d>& points) {
  Box3d box;
  for (const Vec3d& p : points) box.extendBy(p);
  Ball out{box.center(), 0};
  for (const Vec3d& p : points) out.radius = std::max(out.radius, (p - out.centre).length2());
  // Rounded points are in the ball, too.
  out.radius = std::sqrt(out.radius) * (1 + 1e-6) + 1e-6 * (1 + out.centre.length());
  return out;
}

}  // namespace

NearPoints::NearPoints(std::vector<Vec3d> points)
    : at(std::move(points)),
      packs((at.size() + Pack::kLanes - 1) / Pack::kLanes),
      ball(ball_around(at)) {
  for (size_t pack = 0; pack < packs.size(); ++pack) {
    alignas(32) float lanes[3][Pack::kLanes];
    for (size_t lane = 0; lane < Pack::kLanes; ++lane) {
      const Vec3d& p = at[std::min(pack * Pack::kLanes + lane, at.size() - 1)];
      for (int axis = 0; axis < 3; ++axis) lanes[axis][lane] = static_cast<float>(p[axis]);
    }
    packs[pack] = {Pack::load(lanes[0]), Pack::load(lanes[1]), Pack::load(lanes[2])};
  }
}

NearValues values_near(const Node& node, const NearPoints& points, double limit) {
  thread_local Scratch scratch;
  NearValues out;
  out.error = rounding_of(node.traits(), points.ball);
  const Restriction local = restrict_below(node, points.ball, limit + out.error);
  out.range = local.range;
  if (out.range.lo - out.error > limit) return out;
  Scratch::Frame frame(scratch);
  const size_t count = points.packs.size();
  Pack* values = frame.take<Pack>(count);
  (local.node ? *local.node : node)
      .eval(points.packs.data(), static_cast<int>(count), values, scratch);
  out.values.resize(count * Pack::kLanes);
  for (size_t pack = 0; pack < count; ++pack)
    values[pack].store(out.values.data() + pack * Pack::kLanes);
  return out;
}

NearMixes mixes_near(const Node& node, const NearPoints& points) {
  if (const auto* source = dynamic_cast<const NearMaterials*>(&node))
    return source->mixes_near(points);
  if (dynamic_cast<const MaterialSource*>(&node)) return {points.size(), {}, false};
  const std::vector<NodePtr> children = node.children();
  return children.empty() ? NearMixes(points.size(), {}, true)
                          : mixes_near(*children.front(), points);
}

void lay_over(NearMixes& mixes, const Node& body, double contact, const NearPoints& points) {
  const double half = 0.5 * std::max(contact, 0.0);
  const NearValues values = values_near(body, points, half);
  size_t outside = 0;
  for (size_t i = 0; i < points.size(); ++i) outside += values.above(i, half) ? 1 : 0;
  if (outside == points.size()) return;
  const NearMixes own = mixes_near(body, points);
  for (size_t i = 0; i < points.size(); ++i) {
    if (values.above(i, half)) continue;
    if (values.below(i, -half))
      mixes.replace(i, own);
    else
      mixes.known[i] = 0;
  }
}

}  // namespace vug::field
