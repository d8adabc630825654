// SPDX-License-Identifier: Apache-2.0
#include <vug/sgm/glue.h>
#include <vug/sgm/growth.h>
#include <vug/sgm/probe.h>
#include <vug/sgm/region.h>

#include <vug/field/affine.h>
#include <vug/field/boolean.h>

#include <algorithm>

namespace vug::sgm {

using field::Field;

namespace {

bool equal(const field::Blend& a, const field::Blend& b) {
  return a.profile == b.profile && a.radius == b.radius;
}

double reach_of(const field::Blend& blend) {
  return blend.profile == field::Profile::sharp ? 0 : blend.radius;
}

/// The half ball of a local intersection: it contains the shape's outer half and a margin.
struct EndHalfBall {
  Vec3d centre;
  double radius;
};
EndHalfBall end_half_ball(const Field& shape) {
  return {shape.bounds().center(), 0.625 * shape.bounds().size().length()};
}

/// Whether a production acts on all of the base: on request, or because the shape is infinite.
bool acts_everywhere(const ProductionStep& step, const Options& options, const Field& shape) {
  return step.reach.value_or(options.reach) == Reach::whole || !is_finite(shape.bounds());
}

/// The direction in which the base grows at this placement.
Vec3d heading(const Placement& placement) {
  return placement.glued && !placement.base_bond.free_direction() ? placement.base_bond.direction
                                                                  : direction(placement.side);
}

}  // namespace

double Options::Overlap::of(Operation operation) const {
  switch (operation) {
    case Operation::unite:
      return unite;
    case Operation::subtract:
      return subtract;
    case Operation::intersect:
      return intersect;
    case Operation::morph:
      break;
  }
  return morph;
}

Growth::Growth(Options options) : options_(std::move(options)) { options_.geology.require_valid(); }

const Placement& Growth::apply(const ProductionStep& step, RandomKey key, int node) {
  if (step.pieces.empty())
    throw Error(ErrorCode::bad_input, "a production needs a shape", step.where);
  std::vector<Shape> pieces;
  for (const Piece& piece : step.pieces) pieces.push_back(make_shape(piece.name, piece.field));
  Shape shape = compound(pieces, step.piece_label, options_.overlap.unite, key.at("pieces"));

  Placement placement;
  placement.operation = step.operation;
  placement.shape = shape.name;
  placement.node = node;
  placement.side = sample_side(step.label, key.at("side"));
  placement.amount = step.operation == Operation::morph ? step.amount : 0;
  if (shape.field.bounds().isEmpty()) {
    placement.effective = false;
    placement.note = "the shape is empty";
  } else if (!started_) {
    start(std::move(shape), placement);
  } else {
    glue(step, std::move(shape), key, placement);
  }
  if (!placement.effective)
    diagnostics_.warning(step.where, to_string(step.operation) + " with '" + placement.shape +
                                         "' has no effect: " + placement.note);
  placements_.push_back(std::move(placement));
  return placements_.back();
}

void Growth::start(Shape shape, Placement& placement) {
  placement.note = "starts the base";
  placement.field = shape.field;
  field_ = shape.field;
  terms_ = {field_};
  bonds_.add(shape.bonds, size_of(field_));
  started_ = true;
}

void Growth::glue(const ProductionStep& step, Shape shape, RandomKey key, Placement& placement) {
  std::optional<PooledBond> own;
  if (const auto moving = opposite_bond(shape, placement.side, key.at("turn"))) {
    own = bonds_.take(placement.side, field_, key.at("bond"));
    if (!own) {
      placement.effective = false;
      placement.note = "side " + to_string(placement.side) + " has no free bond";
      return;
    }
    const Bond bond = shape.bonds[*moving];
    shape.bonds.erase(shape.bonds.begin() + static_cast<std::ptrdiff_t>(*moving));
    const Transform glued = glue_transform(own->bond, bond);
    placement.glued = true;
    placement.base_bond = own->bond;
    placement.base_bond_id = own->id;
    placement.shape_bond = {glued.point(bond.point), glued.vector(bond.direction)};
    placement.press =
        step.overlap.value_or(options_.overlap.of(step.operation)) * extent_along(shape, bond);
    placement.map = Transform::translation(-heading(placement) * placement.press) * glued;
    shape = transformed(shape, placement.map);
  } else {
    placement.note = "the shape has no bond and keeps its position";
  }
  placement.field = shape.field;
  if (step.operation == Operation::morph) {
    const Vec3d where = own ? own->bond.point : Vec3d(0);
    placement.amount = options_.geology.amount_at(where, step.amount);
  }
  const std::optional<Field> base = combined(step, placement, shape);
  if (!base) {
    placement.effective = false;
    placement.glued = false;
    placement.base_bond_id = -1;
    placement.note = "nothing would remain";
    if (own) bonds_.release(*own);
    return;
  }
  grow(step, shape, *base, placement);
}

std::optional<Field> Growth::combined(const ProductionStep& step, const Placement& placement,
                                      const Shape& shape) const {
  const bool whole = acts_everywhere(step, options_, shape.field);
  Field out;
  switch (step.operation) {
    case Operation::unite: {
      if (terms_.size() > 1 && !equal(terms_blend_, step.blend))
        return field::unite({field_, shape.field}, step.blend);
      std::vector<Field> terms = terms_;
      terms.push_back(shape.field);
      return field::unite(std::move(terms), step.blend);
    }
    case Operation::subtract:
      out = field::subtract(field_, {shape.field}, step.blend);
      break;
    case Operation::intersect: {
      const EndHalfBall end = whole ? EndHalfBall{} : end_half_ball(shape.field);
      out = whole ? field::intersect({field_, shape.field}, step.blend)
                  : local_intersection(field_, shape.field, end.centre, heading(placement),
                                       end.radius, step.blend);
      break;
    }
    case Operation::morph:
      if (!whole) return local_morph(field_, shape.field, placement.amount, step.blend);
      out = field::morph(field_, shape.field, placement.amount);
      break;
  }
  const double size = size_of(field_);
  // Solid just below a bond usually remains and is quick to find.
  for (const Bond& bond : bonds_.free())
    if (out.value(bond.point - bond.direction * (1e-3 * size)) < -1e-9 * size) return out;
  return inner_point(out) ? std::optional(out) : std::nullopt;
}

void Growth::grow(const ProductionStep& step, const Shape& shape, Field base,
                  const Placement& placement) {
  const bool adds = step.operation == Operation::unite || step.operation == Operation::morph;
  if (step.operation == Operation::unite &&
      (terms_.size() == 1 || equal(terms_blend_, step.blend))) {
    terms_.push_back(shape.field);
    terms_blend_ = step.blend;
  } else {
    terms_ = {base};
  }
  field_ = std::move(base);

  const bool whole = acts_everywhere(step, options_, shape.field);
  // Cuts also consume their bond, but they join nothing, so the new wall gets a new bond.
  const double depth = whole ? size_of(field_) : std::min(size_of(field_), size_of(shape.field));
  const double reach = reach_of(step.blend) + 1e-6 * size_of(field_);
  const EndHalfBall end = whole ? EndHalfBall{} : end_half_ball(shape.field);
  bonds_.reproject(field_, depth, [&](const Bond& bond) {
    if (whole) return true;
    if (step.operation == Operation::intersect)
      return (bond.point - end.centre).length() < end.radius + reach;
    return shape.field.value(bond.point) < reach;  // Otherwise the base's value there is unchanged.
  });
  std::vector<Bond> fresh;
  if (adds) {
    if (placement.glued) bonds_.consume(placement.base_bond);
    for (const Bond& bond : shape.bonds)
      if (const auto on = recast(bond, field_, depth)) fresh.push_back(*on);
  } else if (placement.glued) {
    const double thickness = 0.25 * extent_along(shape, placement.base_bond);
    if (const auto on = recast(placement.base_bond, field_, depth, thickness)) fresh.push_back(*on);
  }
  bonds_.add(fresh, size_of(field_));
}

}  // namespace vug::sgm
