// SPDX-License-Identifier: Apache-2.0
#include <vug/field/box_lanes.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace vug::field {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr size_t kGrouped = 64;  // Fewer lanes are visited without their groups.

/// Bounds of values, lane by lane: `low` and `high` are the corners of boxes relative to the least
/// and the greatest coordinates, and `nearer` is what the distance may be shorter.
Pack least_value(const Pack (&low)[3], const Pack (&high)[3], const Pack& growth, const Pack& depth,
                 const Pack& nearer, const Pack& margin) {
  const Pack zero(0.0);
  Pack squared = zero;
  for (int axis = 0; axis < 3; ++axis) squared += square(max(max(low[axis], high[axis]), zero));
  const Pack away = sqrt(squared) - nearer;
  return select(away > zero, away * growth, -depth) - margin;
}

template <class Visit>
void for_each_lane(const PackMask& mask, const Visit& visit) {
  for (auto bits = static_cast<unsigned>(_mm256_movemask_ps(mask.bits)); bits != 0;
       bits &= bits - 1)
    visit(static_cast<size_t>(std::countr_zero(bits)));
}

float least_lane(const Pack& p) {
  float lanes[Pack::kLanes];
  p.store(lanes);
  return *std::min_element(lanes, lanes + Pack::kLanes);
}
float greatest_lane(const Pack& p) { return -least_lane(-p); }

}  // namespace

void BoxLanes::add(const Box3d& box, double growth, double depth) {
  const bool known = growth > 0;
  const size_t lane = count_ % kLanes, block = count_ / kLanes, lane_of_block = block % kLanes;
  ++count_;
  if (lane == 0) lanes_.emplace_back();
  if (lane == 0 && lane_of_block == 0) groups_.emplace_back();
  Lanes &own = lanes_.back(), &group = groups_.back();
  double farthest = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const float low = known ? static_cast<float>(box.min[axis]) : -kInfinite,
                high = known ? static_cast<float>(box.max[axis]) : kInfinite;
    own.low[axis][lane] = low;
    own.high[axis][lane] = high;
    float &group_low = group.low[axis][lane_of_block],
          &group_high = group.high[axis][lane_of_block];
    group_low = lane == 0 ? low : std::min(group_low, low);
    group_high = lane == 0 ? high : std::max(group_high, high);
    if (known) farthest += std::max(std::fabs(box.min[axis]), std::fabs(box.max[axis]));
  }
  own.growth[lane] = static_cast<float>(growth);
  own.depth[lane] = known ? static_cast<float>(1.001 * depth) : kInfinite;
  own.margin[lane] = static_cast<float>(4e-6 * farthest);  // Above the errors of values.
  const auto add = [&](float& of_group, float value, bool least) {
    of_group = lane == 0 ? value : least ? std::min(of_group, value) : std::max(of_group, value);
  };
  add(group.growth[lane_of_block], own.growth[lane], true);
  add(group.depth[lane_of_block], own.depth[lane], false);
  add(group.margin[lane_of_block], own.margin[lane], false);
}

Pack BoxLanes::bound(const Lanes& lanes, const Region& region) {
  Pack low[3], high[3];
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = Pack::load(lanes.low[axis]) - Pack(region.greatest[axis]);
    high[axis] = Pack(region.least[axis]) - Pack::load(lanes.high[axis]);
  }
  const Pack margin = Pack::load(lanes.margin);
  return least_value(low, high, Pack::load(lanes.growth), Pack::load(lanes.depth),
                     margin + Pack(region.nearer), margin);
}

template <class Visit>
void BoxLanes::visit_candidates(const Region& region, const Pack& limit, const Visit& visit) const {
  const auto near = [&](const Lanes& lanes) { return !(bound(lanes, region) > limit); };
  const auto visit_block = [&](size_t block) {
    for_each_lane(near(lanes_[block]), [&](size_t lane) {
      if (block * kLanes + lane < count_) visit(block * kLanes + lane);
    });
  };
  if (lanes_.size() < kGrouped) {
    for (size_t block = 0; block < lanes_.size(); ++block) visit_block(block);
    return;
  }
  for (size_t group = 0; group < groups_.size(); ++group)
    for_each_lane(near(groups_[group]), [&](size_t lane) {
      const size_t block = group * kLanes + lane;
      if (block < lanes_.size()) visit_block(block);
    });
}

std::optional<size_t> BoxLanes::nearest(const Vec3d& p) const {
  std::optional<size_t> out;
  float least = kInfinite;
  // To the box, and a little to its middle, for points inside of several.
  const auto squares = [&](const Lanes& lanes, double to_middle) {
    Pack squared(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      const Pack low = Pack::load(lanes.low[axis]) - Pack(p[axis]),
                 high = Pack(p[axis]) - Pack::load(lanes.high[axis]);
      squared += square(max(max(low, high), Pack(0.0)));
      if (to_middle > 0) squared += square((low - high) * Pack(to_middle));
    }
    return squared;
  };
  for (size_t group = 0; group < groups_.size(); ++group)
    for_each_lane(!(squares(groups_[group], 0) >= Pack(least)), [&](size_t lane_of_block) {
      const size_t block = group * kLanes + lane_of_block;
      if (block >= lanes_.size()) return;
      float lanes[kLanes];
      squares(lanes_[block], 0.05).store(lanes);
      for (size_t lane = 0; lane < kLanes && block * kLanes + lane < count_; ++lane) {
        if (!(lanes[lane] < least)) continue;  // NaN without bounds.
        least = lanes[lane];
        out = block * kLanes + lane;
      }
    });
  return out;
}

void BoxLanes::find_candidates(const Ball& ball, double limit, std::vector<uint32_t>& out) const {
  Region region;
  for (int axis = 0; axis < 3; ++axis)
    region.least[axis] = region.greatest[axis] = static_cast<float>(ball.centre[axis]);
  region.nearer = static_cast<float>(ball.radius * (1 + 1e-6) + 1e-6 * ball.centre.length());
  visit_candidates(region, Pack(limit + 1e-6 * std::fabs(limit)),
                   [&](size_t i) { out.push_back(static_cast<uint32_t>(i)); });
}

void BoxLanes::find_candidates(const Point<Pack>* points, const Pack* limits, int count,
                               uint64_t* masks) const {
  std::fill(masks, masks + count_, 0);
  for (int k = 0; k < count; ++k) {
    const Pack* axes[] = {&points[k].x, &points[k].y, &points[k].z};
    Region region;
    for (int axis = 0; axis < 3; ++axis) {
      region.least[axis] = least_lane(*axes[axis]);
      region.greatest[axis] = greatest_lane(*axes[axis]);
    }
    visit_candidates(region, Pack(greatest_lane(limits[k])),
                     [&](size_t i) { masks[i] |= uint64_t{1} << k; });
  }
}

bool BoxLanes::above(size_t i, const Point<Pack>& p, const Pack& limit) const {
  const Lanes& boxes = lanes_[i / kLanes];
  const size_t lane = i % kLanes;
  const Pack* axes[] = {&p.x, &p.y, &p.z};
  Pack low[3], high[3];
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = Pack(boxes.low[axis][lane]) - *axes[axis];
    high[axis] = *axes[axis] - Pack(boxes.high[axis][lane]);
  }
  const Pack margin(boxes.margin[lane]);
  const Pack bound =
      least_value(low, high, Pack(boxes.growth[lane]), Pack(boxes.depth[lane]), margin, margin);
  return !any(!(bound > limit));
}

}  // namespace vug::field
