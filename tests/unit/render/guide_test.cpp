// SPDX-License-Identifier: Apache-2.0
// The guide: its densities are normalized, and it recovers the light distribution that it was
// trained with.
#include "chi2.h"

#include <gtest/gtest.h>
#include <vug/base/rng.h>
#include <vug/render/guiding/guide.h>
#include <vug/render/guiding/radiance_cache.h>
#include <vug/render/sampling.h>

namespace vug::render {
namespace {

constexpr float kEdge = 0.25f;

Vec2f pair(uint64_t i, uint64_t salt) {
  RandomStream stream{RandomKey(salt).at(i)};
  return {static_cast<float>(stream.uniform()), static_cast<float>(stream.uniform())};
}

/// A floor of 16 m by 16 m, sampled uniformly, with bright squares of 1 m about the given points.
std::vector<RadianceSample> floor_with(const std::vector<Vec3f>& bright, float luminance) {
  std::vector<RadianceSample> radiance_samples;
  for (uint64_t i = 0; i < 40000; ++i) {
    const Vec2f u = pair(i, 5);
    const Vec3f point(16 * u.x - 8, 0.01f, 16 * u.y - 8);
    float seen = 1;
    for (const Vec3f& b : bright)
      if (std::fabs(point.x - b.x) < 0.5f && std::fabs(point.z - b.z) < 0.5f) seen = luminance;
    radiance_samples.push_back({point, {0, 1, 0}, seen});
  }
  return radiance_samples;
}

const Box3f kRoom(Vec3f(-8, 0, -8), Vec3f(8, 8, 8));

TEST(Guide, TurnsAreAngles) {
  for (int i = 0; i < 1000; ++i) {
    const double turn = i / 1000.0;
    const SinCos sc = sincos_turns(static_cast<float>(turn));
    const double off = static_cast<double>(turns_of(sc.sin, sc.cos)) - turn;
    EXPECT_LT(std::fabs(off - std::round(off)), 2e-7) << turn;
  }
}

TEST(ConeMixture, SamplesItsDensity) {
  ConeMixture cones;
  const auto add = [&](const Vec3f& to, float radius, float share, uint32_t id) {
    const Vec3f axis = normalized(to);
    const auto all = [](float v) { return _mm256_set1_ps(v); };
    cones.add({all(axis.x), all(axis.y), all(axis.z),
               all(one_minus_cosine(radius * radius / dot(to, to))), all(share), id},
              1);
  };
  add({0.5f, 2, -1}, 0.9f, 3, 7);
  add({0.2f, 1.5f, -1}, 0.8f, 1, 4);  // overlaps the first
  add({-3, 0, 0.1f}, 1.5f, 2, 0);
  cones.normalize(0.5f);
  EXPECT_EQ(cones.id(cones.choose(0.2f)), 7u);
  EXPECT_EQ(cones.id(cones.choose(0.6f)), 4u);
  EXPECT_EQ(cones.id(cones.choose(0.9f)), 0u);
  const Chi2 result = chi2(
      normalized(Vec3f(0.5f, 2, -1)), 2, 400000,
      [&](int s) {
        const Vec3f d = cones.sample(pair(static_cast<uint64_t>(s), 7));
        return DirectionSample{d, static_cast<double>(cones.pdf(d))};
      },
      [&](const Vec3f& d) { return static_cast<double>(cones.pdf(d)); });
  EXPECT_GT(result.p, 0.01);
  EXPECT_NEAR(result.integral, 1, 5e-3);
}

TEST(BrightClusters, AreWhereItIsBright) {
  const std::vector<Vec3f> bright = {{3, 0, 2}, {-5, 0, -4}};
  const std::vector<BrightCluster> clusters =
      find_bright_clusters(floor_with(bright, 40), kEdge, 8);
  ASSERT_EQ(clusters.size(), 8u);
  float power = 0;
  for (const BrightCluster& cluster : clusters) {
    float nearest = 100;
    for (const Vec3f& b : bright) nearest = std::min(nearest, length(cluster.center - b));
    EXPECT_LT(nearest + cluster.radius, 1.4f);
    power += cluster.power;
  }
  // Two square metres of 40, and the rims of the cubes; the prior of each cube counts as one sample
  // in eleven.
  EXPECT_NEAR(power, 80, 20);
  EXPECT_TRUE(find_bright_clusters(floor_with({}, 1), kEdge, 8).empty());
  EXPECT_TRUE(find_bright_clusters({}, kEdge, 8).empty());
}

TEST(Guide, PrefersVisibleClusters) {
  const Vec3f one(4, 0, 0), other(-4, 0, 0), from(0, 6, 0);
  const Guide open(floor_with({one, other}, 200), kRoom);
  ASSERT_FALSE(open.empty());
  std::vector<VisibilitySample> visibility_samples;
  for (uint32_t k = 0; k < open.clusters().size(); ++k)
    for (int i = 0; i < 50; ++i) {
      visibility_samples.push_back({from, k, open.clusters()[k].center.x > 0});
      visibility_samples.push_back({{-7.5f, 1, 7.5f}, k, true});  // from another region
    }
  Guide informed = open;
  informed.update_visibility(visibility_samples);
  const auto towards = [&](const Guide& guide, const Vec3f& at) {
    const ConeMixture cones = guide.at(from, {0, -1, 0});
    return cones.mixture_weight() * cones.pdf(normalized(at - from));
  };
  // All 50 against none, each with a prior of the two regions together: p is 25 times larger.
  EXPECT_GT(towards(informed, one) * towards(open, other),
            3 * towards(informed, other) * towards(open, one));
  // Clusters behind a surface do not light it.
  EXPECT_EQ(informed.at(from, {0, 1, 0}).size(), 0u);
  EXPECT_EQ(Guide().at(from, {0, -1, 0}).mixture_weight(), 0);
}

TEST(VisibilityCache, CountsRegionByRegion) {
  std::vector<VisibilitySample> visibility_samples;
  for (int i = 0; i < 200; ++i) {
    visibility_samples.push_back({{-3, 1, 0}, 0, i % 4 == 0});  // a quarter
    visibility_samples.push_back({{3, 1, 0}, 0, true});
    visibility_samples.push_back({{3, 1, 0}, 1, false});
  }
  const VisibilityCache visibility(kRoom, 2 / diagonal_of(kRoom), 2, visibility_samples);
  const auto part = [&](const Vec3f& at, size_t thing) {
    const float root = visibility.at(at)[thing];
    return root * root;
  };
  EXPECT_NEAR(part({-3.5f, 1.5f, 0.5f}, 0), 0.25f, 0.01f);
  EXPECT_NEAR(part({3.5f, 1.5f, 0.5f}, 0), 1, 0.01f);
  // A region without samples gets the global mean; without any samples, all regions do.
  EXPECT_NEAR(part({-3.5f, 1.5f, 0.5f}, 1), 0.005f, 0.005f);
  EXPECT_NEAR(part({0, 7, 7}, 0), 0.625f, 0.01f);
  // Outside the room the nearest region is used.
  EXPECT_EQ(visibility.at({100, 1, 0}), visibility.at({7.9f, 1, 0}));
  EXPECT_GT(part({3, 1, 0}, 1), 0) << "nothing is ruled out";
  std::vector<VisibilitySample> backwards(visibility_samples.rbegin(), visibility_samples.rend());
  const VisibilityCache same(kRoom, 2 / diagonal_of(kRoom), 2, backwards);
  EXPECT_EQ(same.at({-3, 1, 0})[0], visibility.at({-3, 1, 0})[0]);
  EXPECT_TRUE(VisibilityCache().empty());
}

TEST(RadianceCache, DependsOnPositionAndNormal) {
  const Vec3f up(0, 1, 0), down(0, -1, 0);
  std::vector<RadianceSample> radiance_samples;
  for (int i = 0; i < 400; ++i) {
    const bool found = i % 4 == 0;  // a quarter of the paths finds light of 4
    radiance_samples.push_back({{-3, 1, 0}, up, found ? 5.0f : 1.0f, true, found ? 4.0f : 0.0f});
    radiance_samples.push_back({{-3, 1, 0}, down, 0.1f, true, 0.1f});
    radiance_samples.push_back({{3, 1, 0}, up, 100, false, 0});
  }
  const RadianceCache known(radiance_samples, kRoom, 2 / diagonal_of(kRoom));
  // The global mean counts as half a sample.
  EXPECT_NEAR(known.at({-3.5f, 1.5f, 0.5f}, down).mean, 0.1f, 0.05f);
  EXPECT_NEAR(known.at({-3.5f, 1.5f, 0.5f}, down).indirect, 0.1f, 0.05f);
  EXPECT_NEAR(known.at({-3.5f, 1.5f, 0.5f}, up).indirect, 2, 0.01f) << "sqrt(16 / 4)";
  EXPECT_NEAR(known.at({3, 1, 0}, up).indirect, 0, 0.1f);
  // The camera sees 2 and 0.1 equally often: nothing counts less because something brighter is
  // near.
  EXPECT_FLOAT_EQ(known.at({-3, 1, 0}, up).mean, 1.05f);
  EXPECT_FLOAT_EQ(known.at({3, 1, 0}, up).mean, 1.05f);
  // Of three points with equally many paths: in the first, a quarter finds 5 and the rest 1, with a
  // mean that is clamped to the picture's.
  EXPECT_GT(known.noise(), 0);
  EXPECT_LT(known.noise(), 1);
  // Without samples, any light may still arrive.
  EXPECT_GT(known.at({0, 7, 7}, up).indirect, 0.5f);
  EXPECT_TRUE(RadianceCache().empty());
}

}  // namespace
}  // namespace vug::render
