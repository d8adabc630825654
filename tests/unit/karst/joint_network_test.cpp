// SPDX-License-Identifier: Apache-2.0
// Joints of finite length, and passages that follow them.
#include "caves.h"

#include <gtest/gtest.h>
#include <vug/karst/joint_samples.h>
#include <vug/karst/joint_traces.h>
#include <vug/karst/separation.h>

#include <algorithm>
#include <cmath>

namespace vug::karst {
namespace {

constexpr double kDegree = kPi / 180;

std::vector<SegmentPiece> traces_of(const Geology& geology, const KarstOptions& options) {
  return joint_traces(geology, kTracesApart * options.samples.separation,
                      static_cast<size_t>(options.samples.count),
                      RandomKey(options.seed).at("joint traces"));
}

Vec3d way(const SegmentPiece& s) { return s.to - s.from; }

TEST(JointTraces, NearlyParallelOnesKeepApartAndDirectionsFollowTheirFamily) {
  const Preset& preset = find_preset("maze_rectilinear");
  Geology geology = preset.geology;
  geology.fractures.resize(1);
  const std::vector<SegmentPiece> traces = traces_of(geology, preset.options);
  EXPECT_GT(traces.size(), 200u);
  const FractureFamily& family = geology.fractures[0];
  double length = 0, squares = 0;
  for (size_t i = 0; i < traces.size(); ++i) {
    length += way(traces[i]).length();
    const double azimuth = std::atan2(way(traces[i]).x, -way(traces[i]).z);
    const double turn = std::remainder(azimuth - family.azimuth, kPi);
    squares += turn * turn;
    for (size_t j = 0; j < i; ++j) {
      if (std::abs(way(traces[i]).normalized().dot(way(traces[j]).normalized())) <
          std::sqrt(1 - kLeastSine * kLeastSine) + 1e-9)
        continue;
      EXPECT_GE(distance2(traces[i], traces[j]), 16 - 1e-9);
    }
  }
  const auto count = static_cast<double>(traces.size());
  EXPECT_NEAR(std::sqrt(squares / count), family.spread, 0.25 * family.spread);
  EXPECT_GT(length / count, 2 * family.spacing);
}

TEST(JointTraces, AreFewForTinySpacings) {
  Geology geology = small_geology();
  geology.fractures = {{.spacing = 1e-9}};
  EXPECT_LE(joint_traces(geology, 4, 100, RandomKey(1)).size(), 100u);
}

TEST(JointSamples, AreAtCrossingsAndAlongJoints) {
  Geology geology = small_geology();
  geology.beds = {{.point = Vec3d(0, 3, 0)}};
  const std::vector<SegmentPiece> cross{{Vec3d(-10, 0, 0), Vec3d(10, 0, 0)},
                                        {Vec3d(2, 0, -9), Vec3d(2, 0, 6)}};
  std::vector<Vec3d> points;
  const auto edges = sample_joints(cross, geology, 5, [&](const Vec3d& p) {
    points.push_back(p);
    return static_cast<int>(points.size()) - 1;
  });
  EXPECT_EQ(points[0], Vec3d(2, 3, 0));
  // Joints of 12 + 8 and 9 + 6 m on the sides of the crossing, in pieces of at most 5 m.
  EXPECT_EQ(edges.size(), 3u + 2u + 2u + 2u);
  EXPECT_EQ(points.size(), edges.size() + 1);
  for (const auto& [a, b] : edges)
    EXPECT_LE((points[static_cast<size_t>(a)] - points[static_cast<size_t>(b)]).length(), 5 + 1e-9);
}

/// Whether a leg is on a joint, within half a metre and 5 degrees of its direction in plan.
bool follows(const SegmentPiece& leg, const std::vector<SegmentPiece>& traces) {
  const Vec3d middle = (leg.from + leg.to) * 0.5;
  return std::any_of(traces.begin(), traces.end(), [&](const SegmentPiece& trace) {
    return distance2({middle, middle}, trace) < 0.25 &&
           std::abs(way(trace).normalized().dot(way(leg).normalized())) > std::cos(5 * kDegree);
  });
}

TEST(JointNetwork, PassagesOfTheRectilinearMazeFollowTheirJoints) {
  const Preset& preset = find_preset("maze_rectilinear");
  double on_joints = 0, total = 0;
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    KarstOptions options = preset.options;
    options.seed = seed;
    const std::vector<SegmentPiece> traces = traces_of(preset.geology, options);
    const network::Network cave = generate(preset.geology, options);
    for (const network::Leg& leg : cave.legs) {
      SegmentPiece plan{cave.stations[static_cast<size_t>(leg.from)].position,
                        cave.stations[static_cast<size_t>(leg.to)].position};
      plan.from.y = plan.to.y = 0;
      total += way(plan).length();
      if (follows(plan, traces)) on_joints += way(plan).length();
    }
  }
  EXPECT_GE(on_joints, 0.85 * total);
  std::printf("%.1f %% of the length follows joints\n", 100 * on_joints / total);
}

}  // namespace
}  // namespace vug::karst
