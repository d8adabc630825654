// SPDX-License-Identifier: Apache-2.0
// Segments near their surface: which voxels of a block have values below a limit, and their values.
#include <vug/passages/sweep/capsule_list.h>
#include <vug/passages/sweep/packed_lanes.h>
#include <vug/passages/sweep/segment_loft_frame.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {

using field::FirstOrder;
using field::LatticeBlock;

namespace {

/// Tests with rounded numbers keep voxels within this fraction of the extent of what is tested.
constexpr double kMargin = 1e-4;

FirstOrder converted(const Dual<Pack>& x, const FirstOrder*) { return field::first_order_of(x); }
const Dual<Pack>& converted(const Dual<Pack>& x, const Dual<Pack>*) { return x; }

}  // namespace

/// Coordinates of the points of a block relative to a segment: across the axis in the frame of the
/// loft or of the first section, and along the axis. They change linearly along a run. D exceeds
/// `most` outside of the elliptic cylinder around the section that is wider by `most`, and f does
/// where the distance beyond the ends exceeds `most` plus the depth.
class Segment::BlockFrame {
 public:
  BlockFrame(const Segment& segment, const LatticeBlock& block, double limit) {
    const double size = 7 * block.step, most = std::max(limit, 0.0) / segment.scale_ +
                                               kMargin * (segment.reach_ + size) +
                                               1e-6 * segment.length_;
    const auto [a, b] = segment.loft_ ? segment.loft_->grown_axes(most)
                                      : std::pair(segment.reach_ + most, segment.reach_ + most);
    per_a_ = Pack(1 / (a * a));
    per_b_ = Pack(1 / (b * b));
    low_ = -most - segment.from_.depth;
    high_ = segment.length_ + most + segment.to_.depth;
    end_ = size;
    const Vec3d axes[3] = {segment.loft_ ? segment.loft_->first() : segment.from_.right,
                           segment.loft_ ? segment.loft_->second() : segment.from_.up,
                           segment.along_};
    const Vec3d offset = block.origin - segment.start_;
    const Pack ramp = Pack::ramp() * Pack(block.step);
    for (size_t i = 0; i < 3; ++i) {
      const Vec3d& axis = axes[i];
      slope_[i] = axis.z;
      along_z_[i] = ramp * Pack(axis.z);
      const Pack along_y = ramp * Pack(axis.y);
      for (size_t x = 0; x < 8; ++x)
        (Pack(offset.dot(axis) + static_cast<double>(x) * block.step * axis.x) + along_y)
            .store(first_[i] + 8 * x);
    }
  }

  /// The runs that can have a point within these bounds, by the point of each run between the
  /// planes that is nearest to the axis of the cylinder.
  uint64_t runs() const {
    using field::max, field::min, field::square;
    constexpr double kLeastSlope = 1e-7;
    const double slope = std::fabs(slope_[2]) < kLeastSlope ? kLeastSlope : slope_[2];
    const Pack low(std::min(low_ / slope, high_ / slope)),
        high(std::max(low_ / slope, high_ / slope)), per_slope(1 / slope), end(end_), zero(0.0),
        one(1 + kMargin), du(slope_[0]), dv(slope_[1]);
    const Pack pu = du * per_a_, pv = dv * per_b_;
    const Pack per_curved = Pack(1.0) / max(du * pu + dv * pv, Pack(1e-18) * (per_a_ + per_b_));
    uint64_t out = 0;
    for (int x = 0; x < 8; ++x) {
      const Pack u = Pack::load(first_[0] + 8 * x), v = Pack::load(first_[1] + 8 * x),
                 s = Pack::load(first_[2] + 8 * x) * per_slope;
      const Pack from = max(low - s, zero), to = min(high - s, end);
      const Pack z = min(max((zero - (u * pu + v * pv)) * per_curved, from), to);
      const Pack distance = square(u + z * du) * per_a_ + square(v + z * dv) * per_b_;
      out |= static_cast<uint64_t>(bits_of(both(from <= to, distance <= one))) << (8 * x);
    }
    return out;
  }

  Pack coordinate(size_t i, size_t run) const { return Pack(first_[i][run]) + along_z_[i]; }
  /// The lanes within these bounds.
  unsigned within(const Pack& u, const Pack& v, const Pack& s) const {
    using field::square;
    const field::PackMask between = both(s >= Pack(low_), s <= Pack(high_));
    return bits_of(both(between, square(u) * per_a_ + square(v) * per_b_ <= Pack(1 + kMargin)));
  }

 private:
  Pack along_z_[3], per_a_, per_b_;
  alignas(32) float first_[3][LatticeBlock::kRuns];
  double slope_[3], low_ = 0, high_ = 0, end_ = 0;
};

/// The first segment of a block has no known values, and needs no bound for each lane.
void Segment::pack_below(const LatticeBlock& block, double limit, double above, const Pack* known,
                         PackedLanes& out) const {
  using field::min, field::sqrt, field::square;
  const double margin = kMargin * reach_;
  const Pack highest(limit + margin), more(above + margin);
  const BlockFrame frame(*this, block, limit);
  const AxisFrame<Pack> axis(*this);
  const EllipseLoft loft = loft_.value_or(EllipseLoft());
  const Pack reach(reach_);
  out.clear();
  for (uint64_t runs = frame.runs(); runs != 0; runs &= runs - 1) {
    const auto run = static_cast<size_t>(std::countr_zero(runs));
    const Pack u = frame.coordinate(0, run), v = frame.coordinate(1, run),
               s = frame.coordinate(2, run);
    unsigned lanes = frame.within(u, v, s);
    if (known && lanes != 0) {
      const Pack plane =
          loft_ ? loft.least(u, v, axis.share(s)) : sqrt(square(u) + square(v)) - reach;
      const Pack least = any(axis.beyond(s) > Pack(0.0)) ? axis.capped(plane, s) : plane;
      lanes &= bits_of(least * axis.scale < min(known[run] + more, highest));
    }
    if (lanes != 0) out.add(run, lanes, u, v, s);
  }
  if (out.runs() > 0) out.finish();
}

template <class T>
void Segment::fill_packed(PackedLanes& lanes, field::Scratch& scratch) const {
  constexpr size_t kChunk = 16;  // Packs whose intermediate numbers stay in the first-level cache.
  field::Scratch::Frame frame(scratch);
  Pack* numbers[4];
  for (Pack*& number : numbers) number = frame.take<Pack>(kChunk);
  auto* samples = frame.take<EllipseLoft::Sample<Pack>>(kChunk);
  auto* points = frame.take<Point<Pack>>(kChunk);
  auto* duals = frame.take<Dual<Pack>>(kChunk);
  std::optional<LoftFrame<Pack>> loft;
  if (loft_) loft.emplace(*this);
  const Point<Pack> start = field::constant<Pack>(start_), along = field::constant<Pack>(along_),
                    right = field::constant<Pack>(from_.right),
                    up = field::constant<Pack>(from_.up);
  for (size_t begin = 0; begin < lanes.packs(); begin += kChunk) {
    const size_t count = std::min(kChunk, lanes.packs() - begin);
    if (!loft) {
      for (size_t k = 0; k < count; ++k)
        points[k] = start + right * lanes.number(0, begin + k) + up * lanes.number(1, begin + k) +
                    along * lanes.number(2, begin + k);
      fill(points, static_cast<int>(count), duals, scratch);
      for (size_t k = 0; k < count; ++k)
        keep_result(lanes, begin + k, converted(duals[k], static_cast<const T*>(nullptr)));
      continue;
    }
    for (size_t k = 0; k < count; ++k) {
      for (size_t i = 0; i < 3; ++i) numbers[i][k] = lanes.number(i, begin + k);
      numbers[3][k] = loft->share(numbers[2][k]);
    }
    loft_->samples(numbers[0], numbers[1], numbers[3], static_cast<int>(count), samples, scratch);
    for (size_t k = 0; k < count; ++k) {
      if constexpr (std::is_same_v<T, FirstOrder>)
        keep_result(lanes, begin + k, loft->first_order(samples[k], numbers[2][k]));
      else
        keep_result(lanes, begin + k, loft->finish(samples[k], numbers[2][k]));
    }
  }
}

template void Segment::fill_packed<FirstOrder>(PackedLanes&, field::Scratch&) const;
template void Segment::fill_packed<Dual<Pack>>(PackedLanes&, field::Scratch&) const;

}  // namespace vug::passages
