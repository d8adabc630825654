// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/karst/darts.h>
#include <vug/karst/joint_samples.h>
#include <vug/karst/joint_traces.h>
#include <vug/karst/samples.h>
#include <vug/karst/separation.h>

#include <cmath>

namespace vug::karst {
namespace {

constexpr int kDartsPerSample = 30;
/// Distance between samples, in the mean distance of samples in a square or cubic lattice.
constexpr double kDistance = 0.65;

using Point = std::optional<Vec3d>;

/// Draws random points of one kind each.
class SampleSource {
 public:
  SampleSource(const Rock& rock, RandomKey key) : rock_(rock), random_(key) {}

  Vec3d anywhere() {
    const Box3d& box = rock_.geology().bounds;
    const double x = random_.uniform(box.min.x, box.max.x);
    const double y = random_.uniform(box.min.y, box.max.y);
    return {x, y, random_.uniform(box.min.z, box.max.z)};
  }

  Point on_bed() {
    const auto& beds = rock_.geology().beds;
    Vec3d point = anywhere();
    point.y = beds[random_.below(static_cast<uint32_t>(beds.size()))].height_at(point.x, point.z);
    return point;
  }

  /// On a joint, on a bed if there are beds; half of the points on a joint of a second family, too.
  Point on_joint() {
    const auto count = static_cast<uint32_t>(rock_.joints().size());
    const Geology& g = rock_.geology();
    const Joints& first = rock_.joints()[random_.below(count)];
    const Joints& second = rock_.joints()[random_.below(count)];
    const bool crossing = &first != &second && random_.uniform() < 0.5;
    const Layer* bed =
        g.beds.empty() ? nullptr : &g.beds[random_.below(static_cast<uint32_t>(g.beds.size()))];
    Vec3d point = anywhere();
    const double on_first = first.offset(first.nearest(point));
    const double on_second = second.offset(second.nearest(point));
    // Alternating projections converge to a common point of the planes and the bed.
    for (int step = 0; step < 24; ++step) {
      point += first.normal() * (on_first - point.dot(first.normal()));
      if (crossing) point += second.normal() * (on_second - point.dot(second.normal()));
      if (bed) point.y = bed->height_at(point.x, point.z);
    }
    return point;
  }

  Point in_permeable() {
    const Geology& g = rock_.geology();
    const auto balls = static_cast<uint32_t>(g.permeable.size());
    if (balls > 0 && (g.ghost_rock.empty() || random_.uniform() < 0.5)) {
      const PermeableBall& ball = g.permeable[random_.below(balls)];
      const Vec3d offset(random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1));
      return offset.length() <= 1 && ball.strength > 0 ? Point(ball.center + offset * ball.radius)
                                                       : std::nullopt;
    }
    const Vec3d point = anywhere();
    return rock_.in_ghost_rock(point) ? Point(point) : std::nullopt;
  }

 private:
  const Rock& rock_;
  RandomStream random_;
};

/// Throws darts at the rock. Points of all kinds keep one distance, and those of each kind keep one
/// of their own.
class DartThrower {
 public:
  DartThrower(const Rock& rock, double distance, std::vector<Vec3d>& points)
      : rock_(rock), all_(distance), points_(points) {
    for (const Vec3d& point : points) all_.add(point);
  }

  /// Throws darts until `count` points are accepted or too many were in vain.
  template <class Draw>
  void run(int count, double distance, const Draw& draw) {
    if (count <= 0) return;
    Darts kind(distance);
    for (int64_t left = int64_t{count} * kDartsPerSample; left > 0 && count > 0; --left) {
      const Point point = draw();
      if (!point || !kind.is_free(*point) || add(*point) < 0) continue;
      kind.add(*point);
      --count;
    }
  }

  /// The index of a point that is in the rock and keeps the distance of all kinds, else -1.
  int add(const Vec3d& point) {
    if (!rock_.contains(point) || !all_.is_free(point)) return -1;
    all_.add(point);
    points_.push_back(point);
    return static_cast<int>(points_.size()) - 1;
  }

 private:
  const Rock& rock_;
  Darts all_;
  std::vector<Vec3d>& points_;
};

}  // namespace

Samples draw_samples(const Rock& rock, const KeyPoints& keys, const KarstOptions& options) {
  Samples samples;
  std::vector<Vec3d>& points = samples.points;
  const auto end = [&] { return static_cast<int>(points.size()); };
  for (const Sink& sink : keys.sinks) points.push_back(sink.position);
  samples.springs = end();
  for (const Spring& spring : keys.springs) points.push_back(spring.position);
  samples.entrances = end();
  points.insert(points.end(), keys.entrances.begin(), keys.entrances.end());
  samples.waypoints = end();
  points.insert(points.end(), keys.waypoints.begin(), keys.waypoints.end());
  samples.random = end();

  const Geology& g = rock.geology();
  const SampleOptions& o = options.samples;
  SampleSource source(rock, RandomKey(options.seed).at("samples"));
  const auto share = [&](double fraction, bool possible) {
    return possible ? static_cast<int>(std::lround(fraction * o.count)) : 0;
  };
  const Vec3d size = g.bounds.size();
  const double volume = size.x * size.y * size.z;
  const auto flat_distance = [&](int count, size_t layers) {
    return kDistance * std::sqrt(size.x * size.z * static_cast<double>(layers) / count);
  };
  const auto solid_distance = [&](int count, double volume_of_kind) {
    return kDistance * maths::exp(maths::log(volume_of_kind / count) / 3);
  };

  DartThrower darts(rock, kMeeting * o.separation, points);
  // Samples on joints are the first, because those on beds would leave few places on them.
  const int on_joints = share(o.on_fractures, !rock.joints().empty());
  if (o.joint_network) {
    const std::vector<SegmentPiece> traces =
        joint_traces(g, kTracesApart * o.separation, static_cast<size_t>(o.count),
                     RandomKey(options.seed).at("joint traces"));
    int left = on_joints;
    samples.joint_edges = sample_joints(traces, g, options.shape.leg_length, [&](const Vec3d& p) {
      const int sample = left > 0 ? darts.add(p) : -1;
      left -= sample >= 0;
      return sample;
    });
  } else {
    // Points on joints are on lines, so only repeated points are rejected.
    darts.run(on_joints, 0.2 * flat_distance(on_joints, std::max<size_t>(1, g.beds.size())),
              [&] { return source.on_joint(); });
  }
  const int on_beds = share(o.on_beds, !g.beds.empty());
  darts.run(on_beds, flat_distance(on_beds, g.beds.size()), [&] { return source.on_bed(); });
  double ball_volume = 0;
  for (const PermeableBall& ball : g.permeable)
    ball_volume += 4 * kPi / 3 * ball.radius * ball.radius * ball.radius;
  const bool fields = !g.ghost_rock.empty();
  const int permeable = share(o.in_permeable, ball_volume > 0 || fields);
  darts.run(permeable, solid_distance(permeable, fields ? 0.1 * volume : ball_volume),
            [&] { return source.in_permeable(); });
  // Beds and joints without room for all of their samples leave none to the rest of the rock.
  const int rest = o.count - on_joints - on_beds - permeable;
  darts.run(rest, solid_distance(rest, volume), [&] { return Point(source.anywhere()); });
  return samples;
}

}  // namespace vug::karst
