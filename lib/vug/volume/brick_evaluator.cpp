// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/volume/brick_evaluator.h>

#include <algorithm>

namespace vug::volume {
namespace {

constexpr int64_t kBlock = 8;
constexpr int64_t kSerial = 32;  // Cells of at most this size are one task.

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
  limit_ = std::max(static_cast<double>(walk_.band.background), reach(walk_.band, field));
  descend(field, brick.cell(), units);
}

void BrickEvaluator::visit(const field::Field& outer, const Cell& cell, uint64_t units) {
  if (cell.size > kBlock) progress_.check();
  if (walk_.is_beyond(cell)) return done(units);
  // Nodes that are evaluated near their surface choose operands for each block themselves.
  if (cell.size == kBlock && near_surface_of(outer, walk_.band)) return leaf(outer, cell);
  const field::Field::RestrictedField part =
      outer.restricted_near(ball_around(cell, walk_.band.voxel), limit_);
  switch (side_of(walk_.band, part)) {
    case Side::outside:
      return done(units);
    case Side::inside:
      brick_->fill_inside(cell);
      return done(units);
    case Side::band:
      break;
  }
  cell.size == kBlock ? leaf(part.field, cell) : descend(part.field, cell, units);
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
  evaluate(field, cell, walk_.band, own.scratch, own.block);
  if (own.block.any_active())
    brick_->set(cell, own.block);
  else if (own.block.values[0] < 0)
    brick_->fill_inside(cell);
}

}  // namespace vug::volume
