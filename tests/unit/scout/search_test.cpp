// SPDX-License-Identifier: Apache-2.0
// The search of shots in a simple cave.
#include "rooms.h"

#include <vug/base/parallel.h>
#include <vug/scout/scout.h>
#include <vug/scout/trace_view.h>

#include <algorithm>
#include <cmath>

namespace vug::scout {
namespace {

/// A hall with pillars, a side passage and a figure.
std::string pillars() {
  return hall(
      "volume person = level_set(box(size: (0.4, 1.75, 0.3)).translate((4, 0.87, 0.6)), voxel: "
      "10cm)\n"
      "mesh figure on person {}\nobject someone on figure {}\n"
      "camera main { eye (-10, 2, 0)  target (1, 2, 0) }\n"
      "light lamp = sphere(center: (2, 4, 0), radius: 20cm, lumen: 3000)\n",
      " + tapered_capsule(a: (-2, -1, -1.5), b: (-2, 6, -1.8), radius_a: 0.8, radius_b: 0.5)"
      " + tapered_capsule(a: (5, -1, 1.9), b: (5.4, 6, 1.7), radius_a: 0.7, radius_b: 0.4)"
      " + tapered_capsule(a: (8, -1, -1.6), b: (8, 6, -1.6), radius_a: 0.6, radius_b: 0.6)"
      " - tapered_capsule(a: (-6, 1, 0), b: (-7, 1.2, 12), radius_a: 1.6, radius_b: 1)");
}

TEST(Search, EveryShotStandsOnTheFloorInFreeAir) {
  const Room room(pillars());
  EXPECT_TRUE(room.location.lit);
  ScoutOptions options;
  options.shots = 6;
  const ScoutResult found = find_shots(room.location, options);
  ASSERT_EQ(found.shots.size(), 6u);
  double before = kInfinity;
  for (const ScoutedShot& shot : found.shots) {
    const Vec3d& eye = shot.candidate.pose.eye;
    EXPECT_GT(clearance(*room.location.world, eye), 0.3);
    const auto floor = floor_below(*room.location.world, eye, 3);
    ASSERT_TRUE(floor);
    const double height = eye.y - floor->y;
    EXPECT_TRUE(std::fabs(height - 1.6) < 0.02 || std::fabs(height - 0.7) < 0.02) << height;
    EXPECT_LE(shot.score, before) << "best first";
    before = shot.score;
    EXPECT_EQ(rounded(shot.candidate.pose).eye, eye) << "as it is written";
  }
}

TEST(Search, TheSameShotsForAnyNumberOfThreadsAndOthersForAnotherSeed) {
  const Room room(pillars());
  const auto eyes = [&](int threads, uint64_t seed) {
    ScoutOptions options;
    options.shots = 4;
    options.seed = seed;
    std::vector<Vec3d> out;
    for (const ScoutedShot& shot :
         with_threads(threads, [&] { return find_shots(room.location, options); }).shots)
      out.push_back(shot.candidate.pose.eye);
    return out;
  };
  const auto one = eyes(1, 1);
  EXPECT_EQ(eyes(2, 1), one);
  EXPECT_EQ(eyes(7, 1), one);
  EXPECT_NE(eyes(2, 2), one);
}

TEST(Search, TheFigureIsALandmarkOfKnownSizeAndTheRockIsNot) {
  const Room room(pillars());
  std::vector<View> views;
  for (int i = 0; i < 8; ++i)
    views.push_back(
        trace_view(*room.location.world, *camera_of({Vec3d(-9 + 2 * i, 1.6, 0), 0.8 * i, 0, 1.1})));
  const Landmarks landmarks = find_landmarks(room.location, views);
  uint32_t figure = 0;
  while (room.location.scene.objects.at(figure).name != "someone") ++figure;
  EXPECT_EQ(landmarks.known_size, (std::map<uint32_t, bool>{{figure, true}}));
  EXPECT_GT(landmarks.weights.at(figure), 0.8);
  EXPECT_EQ(landmarks.weights.count(1 - figure), 0u);
  const auto subjects = find_subjects(room.location, landmarks);
  ASSERT_EQ(subjects.size(), 1u);
  EXPECT_LT((subjects[0].position - Vec3d(4, 0.87, 0.6)).length(), 0.05);
}

TEST(Search, ADarkSceneHasNoShotsByItsOwnLight) {
  std::string text = pillars();
  text.replace(text.find("(2, 4, 0), radius"), 9, "(2, 4, 9)");  // the lamp is in the rock
  const Room room(text);
  ScoutOptions options;
  EXPECT_THROW(find_shots(room.location, options), Error);
  options.judge_light = false;
  options.shots = 2;
  EXPECT_EQ(find_shots(room.location, options).shots.size(), 2u);
}

}  // namespace
}  // namespace vug::scout
