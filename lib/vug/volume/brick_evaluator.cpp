// SPDX-License-Identifier: Apache-2.0
#include <vug/base/digester.h>
#include <vug/base/parallel.h>
#include <vug/field/evaluates_below.h>
#include <vug/field/placement.h>
#include <vug/field/translated.h>
#include <vug/volume/brick_evaluator.h>
#include <vug/volume/contact.h>
#include <vug/volume/kept_block.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace vug::volume {
namespace {

constexpr int64_t kBlock = 8;
constexpr int64_t kSerial = 32;  // Cells of at most this size are one task.
constexpr int64_t kHalf = Brick::kSize / 2;

/// The largest coordinate at which parts of an expression are evaluated in single precision, if
/// those of the expression are at most `extent`; in metres of the expression, whose values maps
/// scale. Noises do not count: they have no faces.
double farthest_coordinate(const field::Node& node, double extent) {
  double stretch = 1;
  if (const auto inverse = field::inverse_placement_of(node)) {
    double farthest = 0;
    for (int axis = 0; axis < 3; ++axis) {
      double sum = 0;
      for (int i = 0; i < 3; ++i) sum += std::fabs(inverse->column(i)[axis]);
      stretch = std::max(stretch, sum / std::sqrt(3.0));
      farthest = std::max(farthest, sum * extent + std::fabs(inverse->origin()[axis]));
    }
    extent = farthest;
  }
  double farthest = extent;
  const auto visit = [&](const field::Node& child) {
    const field::Traits& traits = child.traits();
    if (traits.exactness != field::Exactness::sign || is_finite(traits.bounds))
      farthest = std::max(farthest, farthest_coordinate(child, extent));
  };
  // Thousands of speleothems are nodes with one child: no list of children is made for these.
  const auto* passes = field::interface_of<field::EvaluatesBelow>(node);
  if (const field::Node* child = passes ? passes->only_child() : nullptr)
    visit(*child);
  else
    for (const field::NodePtr& each : node.children()) visit(*each);
  return farthest / stretch;
}

}  // namespace

bool OctreeTask::is_beyond(const Cell& cell) const {
  for (int axis = 0; axis < 3; ++axis)
    if (cell.origin[axis] > high[axis] || cell.origin[axis] + cell.size - 1 < low[axis])
      return true;
  return false;
}

Side side_of(const NarrowBand& band, const field::Field::RestrictedField& part) {
  const double limit = reach(band, part.field);
  if (part.range.lo > limit) return Side::outside;
  if (part.range.hi < -limit) return Side::inside;
  return Side::band;
}

void BrickEvaluator::run(const field::Field& field, uint64_t units, Brick& brick) {
  brick_ = &brick;
  Vec3d middle;
  for (int axis = 0; axis < 3; ++axis)
    middle[axis] = static_cast<double>(brick.cell().origin[axis] + kHalf) * band_.voxel;
  const field::Field local = field::translated(field, -middle);
  limit_ = std::max(static_cast<double>(band_.background), reach(band_, local));
  band_.contact = contact_distance(
      farthest_coordinate(*local.node(), static_cast<double>(kHalf) * band_.voxel));
  descend(local, brick.cell(), units);
}

Cell BrickEvaluator::from_middle(const Cell& cell) const {
  Cell out = cell;
  for (int axis = 0; axis < 3; ++axis) out.origin[axis] -= brick_->cell().origin[axis] + kHalf;
  return out;
}

void BrickEvaluator::visit(const field::Field& outer, const Cell& cell, uint64_t units) {
  if (cell.size > kBlock) progress_.check();
  if (walk_.is_beyond(cell)) return done(units);
  // Nodes that are evaluated near their surface choose operands for each block themselves.
  if (cell.size == kBlock && near_surface_of(outer, band_)) return leaf(outer, cell);
  const field::Field::RestrictedField part =
      outer.restricted_near(ball_around(from_middle(cell), band_.voxel), limit_);
  switch (side_of(band_, part)) {
    case Side::outside:
      return done(units);
    case Side::inside:
      brick_->fill_inside(cell);
      return done(units);
    case Side::band:
      break;
  }
  if (cell.size > kBlock) return descend(part.field, cell, units);
  cache_ ? find_leaf(part.field, cell) : leaf(part.field, cell);
}

void BrickEvaluator::descend(const field::Field& field, const Cell& cell, uint64_t units) {
  const auto child = [&](size_t n) {
    visit(field, cell.child(static_cast<int>(n)), cell.size > kSerial ? units / 8 : 0);
  };
  if (cell.size > kSerial) return parallel_for(8, child);
  for (size_t n = 0; n < 8; ++n) child(n);
  done(units);
}

void BrickEvaluator::done(uint64_t units) {
  if (units > 0) progress_.advance(units);
}

void BrickEvaluator::leaf(const field::Field& field, const Cell& cell) {
  Workspace& own = workspaces_.local();
  evaluate(field, from_middle(cell), band_, own.scratch, own.block);
  if (own.block.any_active())
    brick_->set(cell, own.block);
  else if (own.block.values[0] < 0)
    brick_->fill_inside(cell);
}

void BrickEvaluator::find_leaf(const field::Field& field, const Cell& cell) {
  // These restrict themselves to the block, by bounds that the digest does not contain.
  if (near_surface_of(field, band_)) return leaf(field, cell);
  const Cell local = from_middle(cell);
  const Digest key =
      digest_of(field, field.lipschitz(), field.exactness(), local.origin[0], local.origin[1],
                local.origin[2], band_.voxel, band_.background, band_.repair);
  std::shared_ptr<const KeptBlock> known = cache_->find(key, band_.contact);
  if (!known) {
    Workspace& own = workspaces_.local();
    evaluate(field, local, band_, own.scratch, own.block);
    known = std::make_shared<const KeptBlock>(own.block, band_.contact);
    cache_->insert(key, known);
  }
  if (known->active)
    brick_->set(cell, *known->active);
  else if (known->inside)
    brick_->fill_inside(cell);
}

}  // namespace vug::volume
