// SPDX-License-Identifier: Apache-2.0
#include <vug/sgm/probe.h>
#include <vug/sgm/shape.h>

#include <vug/field/affine.h>

#include <cmath>

namespace vug::sgm {

using field::Field;

namespace {

/// The centre of the bounds; on an axis with one finite end that end, with none 0.
Vec3d middle(const Box3d& box) {
  Vec3d out(0);
  for (int i = 0; i < 3; ++i) {
    const bool low = std::isfinite(box.min[i]), high = std::isfinite(box.max[i]);
    if (low && high)
      out[i] = 0.5 * (box.min[i] + box.max[i]);
    else if (low || high)
      out[i] = low ? box.min[i] : box.max[i];
  }
  return out;
}

/// Finds a surface point near the origin by Newton's method along the gradient.
std::optional<Vec3d> surface_near_origin(const Field& field) {
  Vec3d p(0);
  for (int i = 0; i < 64; ++i) {
    const field::Gradient g = field.gradient(p);
    if (std::fabs(g.value) < 1e-12) return p;
    const double slope = g.gradient.length2();
    // Leaves points with a vanishing gradient (symmetric points) by a fixed small step.
    p = slope > 1e-12 ? p - g.gradient * (g.value / slope) : p + Vec3d(0.03, 0.02, 0.01);
    if (!(p.length2() < 1e12)) return std::nullopt;
  }
  return std::fabs(field.value(p)) < 1e-9 ? std::optional(p) : std::nullopt;
}

}  // namespace

double size_of(const Field& field) {
  return is_finite(field.bounds()) ? field.bounds().size().length() : 1;
}

std::optional<Bond> support_bond(const Field& field, Label side) {
  const Vec3d outwards = direction(side);
  const int axis = static_cast<int>(side) / 2;
  const auto point = support_point(field, axis, outwards[axis] > 0 ? 1 : -1);
  return point ? std::optional(Bond{*point, outwards}) : std::nullopt;
}

std::optional<Bond> bond_on(const Field& field, Label side) {
  const Box3d& box = field.bounds();
  if (box.isEmpty()) return std::nullopt;
  const Vec3d outwards = direction(side);
  const int axis = static_cast<int>(side) / 2;
  const double face = (outwards[axis] > 0 ? box.max : box.min)[axis];
  if (!std::isfinite(face)) return std::nullopt;

  const Vec3d centre = middle(box);
  const double size = size_of(field);
  Vec3d start = centre;
  start[axis] = face + outwards[axis] * 1e-6 * size;
  // Up to the centre and slightly past it, so that a wall exactly at the centre counts.
  const double half = std::fabs(start[axis] - centre[axis]) + 2e-6 * size;
  if (const auto t = first_hit(field, start, -outwards, half))
    return Bond{start - outwards * *t, outwards};
  return support_bond(field, side);
}

std::vector<Bond> bonds_of(const Field& field) {
  std::vector<Bond> out;
  const Box3d& box = field.bounds();
  if (box.isEmpty()) return out;
  bool bounded = false;
  for (int s = 0; s < 6; ++s) {
    const int axis = s / 2;
    bounded = bounded || std::isfinite((s % 2 ? box.max : box.min)[axis]);
    if (const auto bond = bond_on(field, static_cast<Label>(s))) out.push_back(*bond);
  }
  if (!bounded)
    if (const auto point = surface_near_origin(field)) out.push_back({*point, Vec3d(0)});
  return out;
}

Shape make_shape(std::string name, Field field) {
  std::vector<Bond> bonds = bonds_of(field);
  return {std::move(name), std::move(field), std::move(bonds)};
}

Shape transformed(const Shape& shape, const Transform& map) {
  Shape out{shape.name, field::transformed(shape.field, map), shape.bonds};
  for (Bond& bond : out.bonds) bond = {map.point(bond.point), map.vector(bond.direction)};
  return out;
}

}  // namespace vug::sgm
