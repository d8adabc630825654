// SPDX-License-Identifier: Apache-2.0
#include <vug/sgm/glue.h>

#include <vug/field/boolean.h>

#include <cmath>

namespace vug::sgm {

Transform glue_transform(const Bond& fixed, const Bond& moving) {
  Transform turn;
  const bool turns = !fixed.free_direction() && !moving.free_direction() &&
                     (fixed.direction + moving.direction).length() > 1e-12;
  if (turns) turn = rotation_between(moving.direction, -fixed.direction);
  return Transform::translation(fixed.point - turn.point(moving.point)) * turn;
}

std::optional<size_t> opposite_bond(const Shape& shape, Label side, RandomKey key) {
  if (shape.bonds.empty()) return std::nullopt;
  std::optional<size_t> undirected;
  for (size_t i = 0; i < shape.bonds.size(); ++i) {
    if (shape.bonds[i].free_direction())
      undirected = undirected ? undirected : i;
    else if (on_side(shape.bonds[i], opposite(side)))
      return i;
  }
  if (undirected) return undirected;
  return RandomStream(key).below(static_cast<uint32_t>(shape.bonds.size()));
}

double extent_along(const Shape& shape, const Bond& bond) {
  if (!is_finite(shape.field.bounds())) return 0;
  const Vec3d size = shape.field.bounds().size();
  double extent = 0;
  for (int i = 0; i < 3; ++i) extent += std::fabs(bond.direction[i]) * size[i];
  return extent;
}

Shape compound(const std::vector<Shape>& pieces, Label label, double overlap, RandomKey key) {
  if (pieces.size() == 1) return pieces[0];
  std::string name;
  std::vector<field::Field> parts;
  std::vector<Bond> free;  // Bonds of the pieces glued so far.
  for (size_t i = 0; i < pieces.size(); ++i) {
    name += (i > 0 ? " + " : "") + pieces[i].name;
    Shape piece = pieces[i];
    const RandomKey own = key.at(i);
    const Label side = sample_side(label, own.at("side"));
    std::vector<size_t> candidates;
    for (size_t b = 0; b < free.size(); ++b)
      if (on_side(free[b], side)) candidates.push_back(b);
    const auto moving = opposite_bond(piece, side, own.at("turn"));
    if (!candidates.empty() && moving) {
      const uint32_t pick =
          RandomStream(own.at("bond")).below(static_cast<uint32_t>(candidates.size()));
      const size_t used = candidates[pick];
      const Bond bond = piece.bonds[*moving];
      const double press = overlap * extent_along(piece, bond);
      const Transform map =
          Transform::translation(-direction(side) * press) * glue_transform(free[used], bond);
      free.erase(free.begin() + static_cast<std::ptrdiff_t>(used));
      piece.bonds.erase(piece.bonds.begin() + static_cast<std::ptrdiff_t>(*moving));
      piece = transformed(piece, map);
    }
    free.insert(free.end(), piece.bonds.begin(), piece.bonds.end());
    parts.push_back(std::move(piece.field));
  }
  return make_shape("(" + name + ")", field::unite(std::move(parts)));
}

}  // namespace vug::sgm
