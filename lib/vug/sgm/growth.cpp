// SPDX-License-Identifier: Apache-2.0
#include <vug/sgm/connection.h>
#include <vug/sgm/glue.h>
#include <vug/sgm/growth.h>
#include <vug/sgm/probe.h>
#include <vug/sgm/region.h>
#include <vug/sgm/spacing.h>

#include <vug/field/affine.h>
#include <vug/field/boolean.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

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

/// The map followed by a rotation about a point that maps a direction to another one.
Transform turned(const Transform& map, const Vec3d& point, const Vec3d& from, const Vec3d& to) {
  if (from == to) return map;
  return Transform::translation(point) * rotation_between(from, to) *
         Transform::translation(-point) * map;
}

/// The compound of a step's pieces.
Shape joined(const ProductionStep& step, const Options& options, RandomKey key) {
  std::vector<Shape> pieces;
  for (const Piece& piece : step.pieces) pieces.push_back(make_shape(piece.name, piece.field));
  return compound(pieces, step.piece_label, options.overlap.unite, key);
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

Vec3d Placement::middle() const {
  return is_finite(field.bounds()) ? field.bounds().center() : map.origin();
}

Growth::Growth(Options options) : options_(std::move(options)) { options_.geology.require_valid(); }

const Placement& Growth::apply(const ProductionStep& step, RandomKey key, int node) {
  if (step.pieces.empty())
    throw Error(ErrorCode::bad_input, "a production needs a shape", step.where);
  const bool single_placed =  // it needs no bonds
      (step.frame || step.connect) && step.pieces.size() == 1;
  Shape shape = single_placed ? Shape{step.pieces[0].name, step.pieces[0].field, {}}
                              : joined(step, options_, key.at("pieces"));

  Placement placement;
  placement.operation = step.operation;
  placement.shape = shape.name;
  placement.name = step.name;
  placement.node = node;
  placement.side = sample_side(step.label, key.at("side"));
  placement.amount = step.operation == Operation::morph ? step.amount : 0;
  if (shape.field.bounds().isEmpty()) {
    placement.effective = false;
    placement.note = "the shape is empty";
  } else if (step.connect) {
    connect(step, shape, placement);
  } else if (step.frame) {
    place_in_frame(step, transformed(shape, *step.frame), placement);
  } else if (!started_) {
    start(std::move(shape), placement);
  } else {
    glue(step, std::move(shape), key, placement);
  }
  if (!placement.effective && !placement.refused)
    diagnostics_.warning(step.where, to_string(step.operation) + " with '" + placement.shape +
                                         "' has no effect: " + placement.note);
  const auto index = static_cast<int>(placements_.size());
  if (adds(placement)) boxes_.add(index, placement.field.bounds());
  if (placement.in_frame && placement.effective) frame_boxes_.add(index, placement.field.bounds());
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

void Growth::place_in_frame(const ProductionStep& step, const Shape& shape, Placement& placement) {
  placement.map = *step.frame;
  placement.field = shape.field;
  placement.in_frame = true;
  if (is_refused(step, placement))
    placement.effective = false;
  else
    place(step, shape, placement);
}

void Growth::place(const ProductionStep& step, const Shape& shape, Placement& placement) {
  placement.field = shape.field;
  if (!started_) {
    start(shape, placement);
    return;
  }
  const bool waits = step.operation == Operation::unite || step.operation == Operation::subtract;
  if (!waits || waiting_.operation != step.operation || !equal(waiting_.blend, step.blend)) flush();
  if (waits) {
    waiting_.operation = step.operation;
    waiting_.blend = step.blend;
    waiting_.shapes.push_back(shape.field);
    return;
  }
  placement.heading = direction(placement.side);
  if (step.operation == Operation::morph)
    placement.amount = options_.geology.amount_at(placement.map.origin(), step.amount);
  const std::optional<Field> base = combined(step, placement, shape);
  placement.effective = base.has_value();
  if (base)
    terms_ = {field_ = *base};
  else
    placement.note = "nothing would remain";
}

int Growth::last_named(const std::string& name, size_t before) const {
  for (size_t i = before; i-- > 0;)
    if (placements_[i].name == name) return static_cast<int>(i);
  return -1;
}

void Growth::connect(const ProductionStep& step, const Shape& shape, Placement& placement) {
  placement.effective = false;
  const auto& [first, second] = *step.connect;
  const int to = last_named(second, placements_.size());
  const size_t before = first == second && to >= 0 ? static_cast<size_t>(to) : placements_.size();
  const int from = last_named(first, before);
  for (const auto& [found, name] : {std::pair(from, first), std::pair(to, second)}) {
    if (found < 0) {
      placement.note = fmt::format("{} earlier shape has the name '{}'",
                                   first == second && to >= 0 ? "only one" : "no", name);
      return;
    }
    const Placement& end = placements_[static_cast<size_t>(found)];
    if (end.effective) continue;
    placement.refused = end.refused;
    placement.note =
        fmt::format("the shape '{}' {}", name, end.refused ? "was left out" : "has no effect");
    return;
  }
  const Vec3d a = placements_[static_cast<size_t>(from)].middle(),
              b = placements_[static_cast<size_t>(to)].middle();
  const double length = (b - a).length();
  if (!is_finite(shape.field.bounds()) || !(length > 0)) {
    placement.note = length > 0 ? "the shape is infinite" : "both places are the same point";
    return;
  }
  const Transform frame = frame_between(a, b);
  placement.map = frame * Transform::translation(-shape.field.bounds().center());
  placement.owner = from;
  placement.other_end = to;
  placement.effective = true;
  placement.field = field::transformed(elongated(shape.field, length), frame);
  if (is_refused(step, placement))
    placement.effective = false;
  else
    place(step, {shape.name, placement.field, {}}, placement);
}

void Growth::flush() {
  std::vector<Field> shapes = std::exchange(waiting_.shapes, {});
  if (shapes.empty()) return;
  if (waiting_.operation == Operation::subtract) {
    terms_ = {field_ = field::subtract(field_, std::move(shapes), waiting_.blend)};
    return;
  }
  if (terms_.size() > 1 && !equal(terms_blend_, waiting_.blend)) terms_ = {field_};
  terms_.insert(terms_.end(), shapes.begin(), shapes.end());
  terms_blend_ = waiting_.blend;
  field_ = field::unite(terms_, terms_blend_);
}

const Field& Growth::field() {
  flush();
  return field_;
}

bool Growth::is_refused(const ProductionStep& step, Placement& placement) const {
  const Limits& limits = step.limits;
  if (limits.within && limits.within->value(placement.middle()) > 0)
    placement.note = "its middle would be outside of 'within'";
  else if (is_too_near(placement, {placements_, placement.in_frame ? frame_boxes_ : boxes_},
                       limits.apart))
    placement.note = "it would be too near to another shape";
  else
    return false;
  placement.refused = true;
  return true;
}

void Growth::glue(const ProductionStep& step, Shape shape, RandomKey key, Placement& placement) {
  flush();
  placement.heading = direction(placement.side);
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
    if (!own->bond.free_direction()) placement.heading = own->bond.direction;
    const Vec3d heading = step.heading.turned(placement.heading);
    const Transform glued =
        turned(glue_transform(own->bond, bond), own->bond.point, placement.heading, heading);
    placement.heading = heading;
    placement.owner = owner_at({placements_, boxes_}, own->bond.point, 1e-3 * size_of(field_));
    placement.glued = true;
    placement.base_bond = own->bond;
    placement.base_bond_id = own->id;
    placement.shape_bond = {glued.point(bond.point), glued.vector(bond.direction)};
    placement.press =
        step.overlap.value_or(options_.overlap.of(step.operation)) * extent_along(shape, bond);
    placement.map = Transform::translation(-placement.heading * placement.press) * glued;
    shape = transformed(shape, placement.map);
  } else {
    placement.note = "the shape has no bond and keeps its position";
  }
  placement.field = shape.field;
  if (step.operation == Operation::morph) {
    const Vec3d where = own ? own->bond.point : Vec3d(0);
    placement.amount = options_.geology.amount_at(where, step.amount);
  }
  const bool refused = is_refused(step, placement);
  const std::optional<Field> base = refused ? std::nullopt : combined(step, placement, shape);
  if (!base) {
    placement.effective = false;
    placement.glued = false;
    placement.base_bond_id = -1;
    if (!refused) placement.note = "nothing would remain";
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
                  : local_intersection(field_, shape.field, end.centre, placement.heading,
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
