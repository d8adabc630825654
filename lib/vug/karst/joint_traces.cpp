// SPDX-License-Identifier: Apache-2.0
#include <vug/karst/joint_traces.h>
#include <vug/karst/joints.h>
#include <vug/karst/separation.h>

#include <algorithm>
#include <cmath>

namespace vug::karst {
namespace {

constexpr double kTraceLength = 3;  ///< Mean length in spacings.
constexpr double kTraceSpread = 0.5;
constexpr double kTraceJitter = 0.35;  ///< Distance of a joint from its mean place, in spacings.
constexpr double kMostTurn = 2;        ///< Standard deviations of a direction.
constexpr double kShortening = 0.1;    ///< Part of a joint that is removed at a time.

/// Joints that keep a distance from nearly parallel ones.
class Traces {
 public:
  Traces(double apart, double side) : apart_(apart), grid_(side, apart) {}

  /// Adds as much of a joint as is separate, if it is longer than `least`.
  void add(const Vec3d& middle, const Vec3d& half, double least) {
    SegmentPiece trace{middle - half, middle + half};
    for (bool at_start = true; is_too_near(trace); at_start = !at_start) {
      const Vec3d step = half * (2 * kShortening);
      // The end that is too near by itself gives way, else one after the other.
      const SegmentPiece first{trace.from + step, trace.to}, second{trace.from, trace.to - step};
      if ((trace.to - trace.from).length() - step.length() < least) return;
      trace = !is_too_near(first)    ? first
              : !is_too_near(second) ? second
              : at_start             ? first
                                     : second;
    }
    grid_.add(static_cast<int>(all_.size()), trace);
    all_.push_back(trace);
  }

  size_t size() const { return all_.size(); }
  std::vector<SegmentPiece> take() { return std::move(all_); }

 private:
  bool is_too_near(const SegmentPiece& trace) const {
    const Vec3d way = trace.to - trace.from;
    return grid_.any_near(trace, [&](int index) {
      const SegmentPiece& other = all_[static_cast<size_t>(index)];
      const Vec3d its = other.to - other.from;
      return (nearly_parallel(way, its, kLeastSine) || nearly_parallel(way, -its, kLeastSine)) &&
             distance2(trace, other) < apart_ * apart_;
    });
  }

  double apart_;
  SegmentGrid grid_;
  std::vector<SegmentPiece> all_;
};

}  // namespace

std::vector<SegmentPiece> joint_traces(const Geology& geology, double apart, size_t most,
                                       RandomKey key) {
  const Vec3d centre(geology.bounds.center().x, 0, geology.bounds.center().z);
  const Vec3d size = geology.bounds.size();
  const double reach = 0.5 * std::sqrt(size.x * size.x + size.z * size.z);
  double side = apart;
  for (const FractureFamily& family : geology.fractures) side = std::max(side, family.spacing);
  Traces traces(apart, side);
  for (size_t f = 0; f < geology.fractures.size(); ++f) {
    const FractureFamily& family = geology.fractures[f];
    const Vec3d along = strike_vector(family.azimuth), across(-along.z, 0, along.x);
    const double spacing = std::max(family.spacing, apart);  // Nearer joints would be thinned out.
    RandomStream random(key.at(f));
    for (double offset = -reach; offset < reach; offset += spacing)
      for (double at = -reach; at < reach && traces.size() < most;) {
        const double length =
            kTraceLength * spacing * random.uniform(1 - kTraceSpread, 1 + kTraceSpread);
        const double aside = offset + spacing * random.uniform(-kTraceJitter, kTraceJitter);
        const double turn = std::clamp(random.normal(), -kMostTurn, kMostTurn);
        const Vec3d direction = strike_vector(family.azimuth + family.spread * turn);
        const Vec3d middle = centre + along * (at + 0.5 * length) + across * aside;
        if (geology.bounds.intersects(Vec3d(middle.x, geology.bounds.center().y, middle.z)))
          traces.add(middle, direction * (0.5 * length), spacing);
        at += length;
      }
  }
  return traces.take();
}

}  // namespace vug::karst
