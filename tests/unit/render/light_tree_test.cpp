// SPDX-License-Identifier: Apache-2.0
// The light tree: the choice is unbiased, its probabilities are as reported, and it pays off.
#include "chi2.h"
#include "scenes.h"
#include "uniform.h"

#include <vug/base/rng.h>
#include <vug/render/lighting/light_set.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace vug::render {
namespace {

Vec3d place(RandomStream& random) {
  const double x = random.uniform(-4, 4), y = random.uniform(-4, 4);
  return {x, y, random.uniform(-4, 4)};
}

std::vector<LightPtr> many_lights(int count, uint64_t seed) {
  RandomStream random{RandomKey(seed)};
  std::vector<LightPtr> out;
  for (int i = 0; i < count; ++i) {
    const Vec3d center = place(random), normal = place(random);
    const double radiance = random.uniform(0.1, 10);
    if (i % 3)
      out.push_back(make_light("rect", {{"center", center},
                                        {"normal", normal},
                                        {"width", 0.2},
                                        {"height", 0.1},
                                        {"radiance", Vec3d(radiance)}}));
    else
      out.push_back(make_light(
          "sphere", {{"center", center}, {"radius", 0.03}, {"radiance", Vec3d(radiance)}}));
  }
  return out;
}

/// An emissive ball, with lights and a sky.
std::vector<Object> shining_ball() {
  Object ball = object(mesh::sphere_mesh({1, 0.5, -2}, 0.7, 2), 0.5);
  ball.emission = Rgb(1, 2, 3);
  return {object(floor_mesh(3), 0.5), ball};
}

LightSampleContext somewhere(RandomStream& random) {
  LightSampleContext point{Vec3f(place(random)), Vec3f(place(random).normalized())};
  if (random.bits() % 3 == 0) point.normal = Vec3f(0.0f);
  return point;
}

/// The same visibility of lights everywhere.
VisibilityCache some_visibility(size_t branches) {
  std::vector<VisibilitySample> visibility_samples;
  for (uint32_t i = 0; i < 20 * branches; ++i)
    visibility_samples.push_back({{0, 0, 0}, i % static_cast<uint32_t>(branches), i % 7 < 3});
  return VisibilityCache(Box3f(Vec3f(-1), Vec3f(1)), 3, branches, visibility_samples);
}

/// The estimate of the sum of 1 over the lights that can contribute, 1 / p each time, must be their
/// number.
TEST(LightTree, EveryLightIsChosenWithItsProbability) {
  for (const int count : {1, 5, 40, 300}) {
    std::vector<LightPtr> all = many_lights(count, 3);
    all.push_back(make_light("portal", {{"center", Vec3d(0, 6, 0)}, {"width", 3.0}}));
    all.push_back(make_light("sky"));
    const LightSet set(all, shining_ball());
    const VisibilityCache chances = some_visibility(set.branches());
    RandomStream random{RandomKey(5)};
    for (int trial = 0; trial < 12; ++trial) {
      const LightSampleContext point = somewhere(random);
      LightSelection selection{trial % 3 == 2 ? 3.0f : 1.0f,
                               trial % 4 == 3 ? LightSampler::uniform : LightSampler::tree,
                               trial % 2 == 1 ? chances.at(point.position) : nullptr};
      SCOPED_TRACE(testing::Message() << count << " lights, trial " << trial);
      constexpr int kDraws = 60000;
      std::map<LightId, int> seen;
      double inverse = 0, squares = 0;
      for (int i = 0; i < kDraws; ++i) {
        double sum = 0;
        std::set<LightId> at_once;
        for (const LightChoice& c : set.choose(point, uniform(random), selection)) {
          const float share = set.pmf(c.light, point, selection);
          ASSERT_NEAR(c.probability, share, 1e-4f * share);
          ASSERT_TRUE(at_once.insert(c.light).second) << "the same light twice";
          ++seen[c.light];
          sum += 1 / static_cast<double>(share);
        }
        ASSERT_LE(at_once.size(), static_cast<size_t>(selection.samples) + 1);
        inverse += sum, squares += sum * sum;
      }
      double sum = 0, possible = 0;
      for (LightId id = 0; id < all.size() + 1000; ++id) {
        const bool known =
            id < all.size() || id - all.size() < shining_ball()[1].mesh->triangles.size();
        if (!known) break;
        const double share = static_cast<double>(set.pmf(id, point, selection));
        sum += share;
        if (share > 0) possible += 1;
        EXPECT_TRUE(share > 0 || seen[id] == 0);
        // Of some 10,000 such comparisons none is beyond 5.5 deviations by chance.
        EXPECT_NEAR(seen[id], share * kDraws, 5.5 * std::sqrt(share * kDraws) + 3)
            << "light " << id;
      }
      EXPECT_LT(sum, static_cast<double>(selection.samples) * (1 + 1e-4));
      const double mean = inverse / kDraws;
      const double error = std::sqrt(std::max(0.0, squares / kDraws - mean * mean) / kDraws);
      EXPECT_NEAR(mean, possible, 4.5 * error + 1e-4 * possible);
    }
  }
}

/// The same for a point on a ray, where each choice reports its own probability.
TEST(LightTree, EveryLightIsChosenWithItsProbabilityAlongRays) {
  for (const int count : {1, 5, 40, 300}) {
    std::vector<LightPtr> all = many_lights(count, 3);
    all.push_back(make_light("portal", {{"center", Vec3d(0, 6, 0)}, {"width", 3.0}}));
    const LightSet set(all, shining_ball());
    const VisibilityCache chances = some_visibility(set.branches());
    RandomStream random{RandomKey(15)};
    for (int trial = 0; trial < 8; ++trial) {
      const Ray ray{Vec3f(place(random)), Vec3f(place(random).normalized())};
      constexpr int kDraws = 60000;
      const LightSelection selection{trial % 3 == 2 ? 3.0f : 1.0f,
                                     trial % 4 == 3 ? LightSampler::uniform : LightSampler::tree};
      std::map<LightId, std::pair<int, float>> seen;
      for (int i = 0; i < kDraws; ++i)
        for (const LightChoice& c :
             set.choose_along(ray, {0.5f, 3}, uniform(random), selection,
                              trial % 2 == 1 ? chances : VisibilityCache())) {
          auto& [times, probability] = seen[c.light];
          if (times++ > 0) {
            ASSERT_NEAR(probability, c.probability, 1e-4f * probability);
          }
          probability = c.probability;
        }
      ASSERT_FALSE(seen.empty());
      for (const auto& [light, found] : seen) {
        const auto p = static_cast<double>(found.second);
        EXPECT_NEAR(found.first, p * kDraws, 5.5 * std::sqrt(p * kDraws) + 3)
            << count << " lights, light " << light;
      }
    }
  }
}

TEST(LightTree, VisibleLightsAreChosenMoreOften) {
  std::vector<LightPtr> all;
  for (const double x : {-2.0, -1.0, 0.0, 1.0, 2.0})
    all.push_back(make_light("sphere", {{"center", Vec3d(x, 2, 0)}, {"radius", 0.1}}));
  const LightSet set(all, {});
  std::vector<VisibilitySample> visibility_samples;
  for (uint32_t i = 0; i < 500; ++i) visibility_samples.push_back({{0, 0, 0}, i % 5, i % 5 == 2});
  const VisibilityCache chances(Box3f(Vec3f(-1), Vec3f(1)), 1, 5, visibility_samples);
  const LightSampleContext point{{0, 0, 0}};
  LightSelection blind, knowing{1, LightSampler::tree, chances.at(point.position)};
  set.choose(point, 0.5f, blind), set.choose(point, 0.5f, knowing);
  const LightId seen = set.choose_in(2, point, 0.5f).light;
  ASSERT_NE(seen, kNoLight);
  for (LightId id = 0; id < 5; ++id) {
    SCOPED_TRACE(id);
    const float share = set.pmf(id, point, knowing) / set.pmf(seen, point, knowing);
    EXPECT_GT(share, 0.009f);
    // None of 100 visibility samples: sqrt(p) is at most a tenth of that of the visible light.
    if (id != seen) {
      EXPECT_LT(share, 0.3f * set.pmf(id, point, blind) / set.pmf(seen, point, blind));
    }
  }
}

/// Bounds must not exclude a light: where a light or one of its samples contributes, its branch has
/// weight.
TEST(LightTree, NoContributingLightIsLeftOut) {
  const std::vector<LightPtr> all = many_lights(200, 7);
  const std::vector<Object> objects = shining_ball();
  const LightSet set(all, objects);
  RandomStream random{RandomKey(6)};
  const auto ids = static_cast<LightId>(all.size() + objects[1].mesh->triangles.size());
  int lit = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const LightSampleContext point = somewhere(random);
    LightSelection selection;
    set.choose(point, 0.5f, selection);
    for (LightId id = 0; id < ids; ++id) {
      const LightSample s = set.sample(id, point, {uniform(random), uniform(random)});
      if (!(s.pdf > 0) || (point.on_surface() && dot(s.direction, point.normal) < 1e-3f)) continue;
      EXPECT_GT(set.pmf(id, point, selection), 0) << "light " << id;
      ++lit;
    }
  }
  EXPECT_GT(lit, 10000);
}

/// Unoccluded light at points of a cave with lights all along it: by the tree, and by a uniform
/// choice.
TEST(LightTree, HasTheMeanOfAUniformChoiceWithMuchLessNoise) {
  constexpr int kLights = 1000, kDraws = 20000;
  std::vector<LightPtr> all;
  RandomStream random{RandomKey(31)};
  for (int i = 0; i < kLights; ++i) {
    const double x = random.uniform(-50, 50), y = random.uniform(-2, 2);
    all.push_back(make_light("sphere", {{"center", Vec3d(x, y, random.uniform(-2, 2))},
                                        {"radius", 0.02},
                                        {"radiance", Vec3d(random.uniform(1, 50))}}));
  }
  const LightSet set(all, {});
  double gain = 0;
  constexpr int kPoints = 8;
  for (int trial = 0; trial < kPoints; ++trial) {
    const LightSampleContext point{{static_cast<float>(random.uniform(-50, 50)), -2.5f, 0},
                                   {0, 1, 0}};
    const auto light = [&](LightId id) {
      const float u = uniform(random);
      const LightSample s = set.sample(id, point, {u, uniform(random)});
      return s.pdf > 0 ? static_cast<double>(s.radiance.y * std::max(0.0f, s.direction.y) / s.pdf)
                       : 0.0;
    };
    double exact = 0;
    for (LightId id = 0; id < kLights; ++id)
      for (int i = 0; i < 16; ++i) exact += light(id) / 16;
    double variance[2] = {0, 0};
    for (const int tree : {0, 1}) {
      double sum = 0, squares = 0;
      for (int i = 0; i < kDraws; ++i) {
        double value = 0;
        if (tree) {
          LightSelection selection;
          for (const LightChoice& c : set.choose(point, uniform(random), selection))
            value = light(c.light) / static_cast<double>(c.probability);
        } else {
          value = kLights * light(random.below(kLights));
        }
        sum += value, squares += value * value;
      }
      const double mean = sum / kDraws;
      variance[tree] = squares / kDraws - mean * mean;
      EXPECT_NEAR(mean, exact, 4 * std::sqrt(variance[tree] / kDraws) + 2e-3 * exact) << tree;
    }
    gain += std::log(variance[0] / variance[1]) / kPoints;
  }
  // With one shadow ray each, a choice by the tree costs less than three uniform ones
  // (bench_lights).
  EXPECT_GT(std::exp(gain), 20);
}

/// Small crystals scattered over a floor, four faces each: at the floor most of the light is of
/// faces near by, half of which face away.
TEST(LightTree, DistinguishesNearbyCrystalFaces) {
  RandomStream random{RandomKey(41)};
  mesh::Mesh mesh;
  for (uint32_t i = 0; i < 1500; ++i) {
    const Vec3f at(8 * uniform(random), 0.05f, 8 * uniform(random));
    for (const Vec3f& corner : {Vec3f(0.02f, 0, -0.012f), Vec3f(-0.02f, 0, -0.012f),
                                Vec3f(0, 0, 0.024f), Vec3f(0, 0.06f, 0)})
      mesh.positions.push_back(at + corner);
    const uint32_t first = 4 * i;
    for (const mesh::Triangle& t : {mesh::Triangle{0, 1, 2}, mesh::Triangle{1, 0, 3},
                                    mesh::Triangle{2, 1, 3}, mesh::Triangle{0, 2, 3}})
      mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  Object crystals;
  crystals.name = "crystals";
  crystals.mesh = std::make_shared<mesh::Mesh>(mesh);
  crystals.emission = Rgb(1);
  const LightSet set({}, {crystals});
  double relative = 0;
  constexpr int kPoints = 50, kDraws = 2000;
  for (int trial = 0; trial < kPoints; ++trial) {
    const LightSampleContext point{{1 + 6 * uniform(random), 0, 1 + 6 * uniform(random)},
                                   {0, 1, 0}};
    double sum = 0, squares = 0;
    for (int i = 0; i < kDraws; ++i) {
      double value = 0;
      LightSelection selection;
      for (const LightChoice& c : set.choose(point, uniform(random), selection)) {
        const float u = uniform(random);
        const LightSample s = set.sample(c.light, point, {u, uniform(random)});
        if (s.pdf > 0 && s.direction.y > 0)
          value += static_cast<double>(s.direction.y / (s.pdf * c.probability));
      }
      sum += value, squares += value * value;
    }
    const double mean = sum / kDraws;
    relative += (squares / kDraws - mean * mean) / (mean * mean * kPoints);
  }
  // Nodes of two have 13.8, of eight 4.9.
  EXPECT_LT(relative, 7);
}

TEST(LightTree, UnionsOfConesContainBoth) {
  RandomStream random{RandomKey(9)};
  for (int trial = 0; trial < 2000; ++trial) {
    LightBounds parts[2];
    for (LightBounds& b : parts) {
      b.box = Box3f(Vec3f(place(random)));
      b.axis = Vec3f(place(random).normalized());
      b.cos_spread = static_cast<float>(random.uniform(-1, 1));
      b.strength = 1;
    }
    const LightBounds both = union_of(parts[0], parts[1]);
    EXPECT_EQ(both.strength, 2);
    for (const LightBounds& b : parts)
      for (int i = 0; i < 20; ++i) {
        const float off = (1 - b.cos_spread) * uniform(random);
        const Vec3f inside = Frame(b.axis).to_world(direction_off_axis(off, uniform(random)));
        EXPECT_GE(dot(inside, both.axis), both.cos_spread - 1e-5f);
      }
  }
}

TEST(LightTree, RaysHitTheSameLightsAsWithoutATree) {
  const std::vector<LightPtr> all = many_lights(400, 11);
  const LightSet set(all, {});
  RandomStream random{RandomKey(12)};
  int met = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const Ray ray{Vec3f(place(random)), Vec3f(place(random).normalized())};
    const float end = trial % 2 ? kFar : 3;
    std::vector<LightId> with, without;
    LightHit hit;
    set.for_each_light_on(ray, end, kNoObject, [&](LightId id, const Light& each) {
      if (each.intersect(ray, end, hit)) with.push_back(id);
    });
    for (LightId id = 0; id < all.size(); ++id)
      if (all[id]->intersect(ray, end, hit)) without.push_back(id);
    std::sort(with.begin(), with.end());
    EXPECT_EQ(with, without);
    met += static_cast<int>(with.size());
  }
  EXPECT_GT(met, 100);
}

TEST(Emitters, TrianglesSampleTheirDensity) {
  Object crystal;
  mesh::Mesh mesh;
  mesh.positions = {{-0.5f, 0, -0.4f}, {0.6f, 0.1f, -0.2f}, {0.1f, -0.2f, 0.7f}};
  mesh.triangles = {{0, 1, 2}};
  crystal.name = "crystal";
  crystal.mesh = std::make_shared<mesh::Mesh>(mesh);
  crystal.emission = Rgb(1);
  const Emitters emitters({crystal});
  ASSERT_EQ(emitters.size(), 1u);
  const Vec3f points[] = {
      {0.1f, -0.3f, 0.05f}, {0.2f, -1, 0.3f}, {2, -0.6f, 1}, {0.3f, -0.06f, -0.1f}, {4, -20, 9}};
  for (const Vec3f& position : points) {
    SCOPED_TRACE("from y = " + std::to_string(position.y));
    RandomStream random{RandomKey(13)};
    const LightSampleContext point{position};
    const Vec3f axis = normalized(emitters.center(0) - position);
    const Vec3f &a = mesh.positions[0], &b = mesh.positions[1], &c = mesh.positions[2];
    const auto inside = [&](const Vec3f& d) {
      const auto side = [&](const Vec3f& p, const Vec3f& q) {
        return dot(cross(p - position, q - position), d);
      };
      const float ab = side(a, b), bc = side(b, c), ca = side(c, a);
      return (ab < 0 && bc < 0 && ca < 0) || (ab > 0 && bc > 0 && ca > 0);
    };
    double widest = 0;
    for (const Vec3f& corner : mesh.positions)
      widest = std::max(widest, 1 - static_cast<double>(dot(axis, normalized(corner - position))));
    const Chi2 result = chi2(
        axis, std::min(2.0, 1.05 * widest), 200000,
        [&](int) -> DirectionSample {
          const float u = uniform(random);
          const LightSample s = emitters.sample(0, point, {u, uniform(random)});
          return {s.direction, static_cast<double>(s.pdf)};
        },
        [&](const Vec3f& d) {
          return inside(d) ? static_cast<double>(emitters.pdf(0, point, d)) : 0.0;
        });
    EXPECT_GT(result.p, 0.002);
    EXPECT_NEAR(result.integral, 1, 5e-3);
    EXPECT_LT(result.stray, 40);
    EXPECT_LT(result.disagreements, 100);
  }
  EXPECT_FALSE(emitters.sample(0, {{0, 2, 0}}, {0.5f, 0.5f}).pdf > 0) << "from behind";
}

}  // namespace
}  // namespace vug::render
