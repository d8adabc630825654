// SPDX-License-Identifier: Apache-2.0
#include <vug/field/box_lanes.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace vug::field {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();

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
  const size_t lane = count_++ % kLanes;
  if (lane == 0) lanes_.emplace_back();
  Lanes& to = lanes_.back();
  const bool known = growth > 0;
  double farthest = 1;
  for (int axis = 0; axis < 3; ++axis) {
    to.low[axis][lane] = known ? static_cast<float>(box.min[axis]) : -kInfinite;
    to.high[axis][lane] = known ? static_cast<float>(box.max[axis]) : kInfinite;
    if (known) farthest += std::max(std::fabs(box.min[axis]), std::fabs(box.max[axis]));
  }
  to.growth[lane] = static_cast<float>(growth);
  to.depth[lane] = known ? static_cast<float>(1.001 * depth) : kInfinite;
  to.margin[lane] = static_cast<float>(4e-6 * farthest);  // Above the errors of values.
}

std::optional<size_t> BoxLanes::nearest(const Vec3d& p) const {
  std::optional<size_t> out;
  float least = kInfinite;
  for (size_t block = 0; block < lanes_.size(); ++block) {
    const Lanes& boxes = lanes_[block];
    Pack squared(0.0);  // To the box, and a little to its middle, for points inside of several.
    for (int axis = 0; axis < 3; ++axis) {
      const Pack low = Pack::load(boxes.low[axis]) - Pack(p[axis]),
                 high = Pack(p[axis]) - Pack::load(boxes.high[axis]);
      squared += square(max(max(low, high), Pack(0.0))) + square((low - high) * Pack(0.05));
    }
    float lanes[kLanes];
    squared.store(lanes);
    for (size_t lane = 0; lane < kLanes && block * kLanes + lane < count_; ++lane) {
      if (!(lanes[lane] < least)) continue;  // NaN without bounds.
      least = lanes[lane];
      out = block * kLanes + lane;
    }
  }
  return out;
}

void BoxLanes::find_candidates(const Ball& ball, double limit, std::vector<uint32_t>& out) const {
  const double radius = ball.radius * (1 + 1e-6) + 1e-6 * ball.centre.length();
  const Pack most(limit + 1e-6 * std::fabs(limit));
  for (size_t block = 0; block < lanes_.size(); ++block) {
    const Lanes& boxes = lanes_[block];
    Pack low[3], high[3];
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = Pack::load(boxes.low[axis]) - Pack(ball.centre[axis]);
      high[axis] = Pack(ball.centre[axis]) - Pack::load(boxes.high[axis]);
    }
    const Pack bound =
        least_value(low, high, Pack::load(boxes.growth), Pack::load(boxes.depth),
                    Pack::load(boxes.margin) + Pack(radius), Pack::load(boxes.margin));
    for_each_lane(!(bound > most), [&](size_t lane) {
      const size_t i = block * kLanes + lane;
      if (i < count_) out.push_back(static_cast<uint32_t>(i));
    });
  }
}

void BoxLanes::find_candidates(const Point<Pack>* points, const Pack* limits, int count,
                               uint64_t* masks) const {
  std::fill(masks, masks + count_, 0);
  for (int k = 0; k < count; ++k) {
    const Pack* axes[] = {&points[k].x, &points[k].y, &points[k].z};
    float least[3], greatest[3];
    for (int axis = 0; axis < 3; ++axis) {
      least[axis] = least_lane(*axes[axis]);
      greatest[axis] = greatest_lane(*axes[axis]);
    }
    const Pack limit(greatest_lane(limits[k]));
    for (size_t block = 0; block < lanes_.size(); ++block) {
      const Lanes& boxes = lanes_[block];
      Pack low[3], high[3];
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = Pack::load(boxes.low[axis]) - Pack(greatest[axis]);
        high[axis] = Pack(least[axis]) - Pack::load(boxes.high[axis]);
      }
      const Pack margin = Pack::load(boxes.margin);
      const Pack bound =
          least_value(low, high, Pack::load(boxes.growth), Pack::load(boxes.depth), margin, margin);
      for_each_lane(!(bound > limit), [&](size_t lane) {
        const size_t i = block * kLanes + lane;
        if (i < count_) masks[i] |= uint64_t{1} << k;
      });
    }
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
