// SPDX-License-Identifier: Apache-2.0
// Rays through a WideBvh against a loop over all triangles, and interleaved paths.
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/mesh/shapes.h>
#include <vug/raytree/bvh_builder.h>
#include <vug/raytree/path_scheduler.h>
#include <vug/raytree/quads.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>

namespace vug::raytree {
namespace {

float number(RandomStream& random) { return static_cast<float>(random.uniform(-1, 1)); }
Vec3f point(RandomStream& random) {
  const float x = number(random), y = number(random);
  return {x, y, number(random)};
}
/// Uniform on the sphere (Archimedes: its z is uniform).
Vec3f direction(RandomStream& random) {
  const double z = 1 - 2 * random.uniform(), angle = 2 * kPi * random.uniform();
  const double r = std::sqrt(1 - z * z);
  return normalized(Vec3f(Vec3d(r * std::cos(angle), r * std::sin(angle), z)));
}

/// Scattered triangles; each third shares an edge with the one before it.
mesh::MeshPtr scattered_triangles(size_t count, uint64_t seed) {
  auto mesh = std::make_shared<mesh::Mesh>();
  RandomStream random{RandomKey(seed)};
  for (size_t i = 0; i < count; ++i) {
    const auto first = static_cast<uint32_t>(mesh->positions.size());
    const Vec3f middle = point(random);
    if (i % 3 == 2) {
      mesh->positions.push_back(middle);
      const mesh::Triangle before = mesh->triangles.back();
      mesh->triangles.push_back({before[2], before[1], first});
      continue;
    }
    for (int k = 0; k < 3; ++k) mesh->positions.push_back(middle + point(random) * 0.2f);
    mesh->triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

struct Nearest {
  double distance = 1e30;
  uint32_t part = 0, triangle = 0;
};
/// Tests all triangles in double precision.
Nearest brute_force(const std::vector<WideBvh::Geometry>& parts, const Ray& ray) {
  Nearest nearest;
  const Vec3d o(ray.origin), d(ray.direction);
  for (const WideBvh::Geometry& part : parts)
    for (uint32_t i = 0; i < part.mesh->triangles.size(); ++i) {
      const auto [a, b, c] = mesh::corners(*part.mesh, i);
      const Vec3d ab = b - a, ac = c - a, p = d.cross(ac), s = o - a, q = s.cross(ab);
      const double volume = p.dot(ab);
      const double u = p.dot(s) / volume, v = q.dot(d) / volume, t = q.dot(ac) / volume;
      if (u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t < nearest.distance)
        nearest = {t, part.id, i};
    }
  return nearest;
}

/// Properties of a tree, collected from its root.
struct TreeStats {
  std::multiset<uint32_t> boxes;
  size_t nodes = 0, deepest = 0;
};
void collect(const BvhBuilder::BuildNode& part, size_t depth, TreeStats& out) {
  out.deepest = std::max(out.deepest, depth);
  if (part.quads > 0) {
    const auto& leaf = static_cast<const BvhBuilder::Leaf&>(part);
    for (size_t i = 0; i < leaf.quads; ++i) out.boxes.insert(leaf.quad[i].second);
    return;
  }
  const BvhBuilder::Children children = BvhBuilder::children(part);
  ++out.nodes;
  EXPECT_GE(children.count, 2u);
  for (const BvhBuilder::BuildNode* child : children) {
    for (size_t axis = 0; axis < 3; ++axis) {
      EXPECT_GE(child->box.min[axis], part.box.min[axis]);
      EXPECT_LE(child->box.max[axis], part.box.max[axis]);
    }
    collect(*child, depth + 1, out);
  }
}
TreeStats build_and_check(const std::vector<RTCBuildPrimitive>& boxes) {
  const BvhBuilder plan(boxes);
  TreeStats out;
  collect(*plan.root(), 0, out);
  EXPECT_EQ(out.boxes.size(), boxes.size());
  EXPECT_EQ(std::set<uint32_t>(out.boxes.begin(), out.boxes.end()).size(), boxes.size());
  EXPECT_LE(out.deepest, size_t{BvhBuilder::kDepth});
  return out;
}
RTCBuildPrimitive box_at(const Vec3f& p, float size, size_t number) {
  return {p.x, p.y, p.z, 0, p.x + size, p.y + size, p.z + size, static_cast<uint32_t>(number)};
}

TEST(BvhBuilder, HoldsEachBoxOnce) {
  RandomStream random{RandomKey(3)};
  std::vector<RTCBuildPrimitive> boxes;
  for (size_t i = 0; i < 20000; ++i) boxes.push_back(box_at(direction(random), 0.01f, i));
  EXPECT_LE(build_and_check(boxes).deepest, 8u);
}

/// 128 leaves in a row. Splitting the largest child from the top down would give a root with eight
/// nodes of eight pairs: 73 nodes. With 16 leaves collapsed into a full node, a pair and six leaves
/// there are 25, and a few more where Embree splits a row off its middle.
TEST(BvhBuilder, FillsItsNodes) {
  std::vector<RTCBuildPrimitive> row;
  for (size_t i = 0; i < 256; ++i) row.push_back(box_at({static_cast<float>(i), 0, 0}, 1, i));
  EXPECT_LE(build_and_check(row).nodes, 30u);
}

/// Boxes of all magnitudes, and all at one position, which break builders that split at midpoints.
TEST(BvhBuilder, HandlesBoxesOfAllSizesAndAllAtOnePlace) {
  std::vector<RTCBuildPrimitive> shrinking, same;
  for (size_t i = 0; i < 20000; ++i) {
    const float size = std::ldexp(1.0f, static_cast<int>(i % 250) - 125);
    shrinking.push_back(box_at(Vec3f(size), size, i));
    same.push_back(box_at(Vec3f(1), 1, i));
  }
  build_and_check(shrinking);
  build_and_check(same);
  EXPECT_EQ(BvhBuilder({}).root(), nullptr);
}

TEST(Quads, HoldEachTriangleOnceInItsOrder) {
  const mesh::MeshPtr scattered_mesh = scattered_triangles(1000, 1);
  const mesh::Mesh ball = mesh::sphere_mesh(Vec3d(0), 1, 4);
  for (const mesh::Mesh* mesh : {scattered_mesh.get(), &ball}) {
    const std::vector<Quad> quads = pair_triangles(*mesh);
    std::set<uint32_t> seen;
    for (const Quad& quad : quads)
      for (size_t half = 0; half < 2; ++half) {
        const auto [triangle, turn] = quad.halves[half];
        if (triangle == Quad::kNoTriangle) continue;
        EXPECT_TRUE(seen.insert(triangle).second);
        const auto& c = quad.corners;
        const std::array<uint32_t, 3> begun = half == 0 ? std::array<uint32_t, 3>{c[0], c[1], c[3]}
                                                        : std::array<uint32_t, 3>{c[2], c[3], c[1]};
        for (size_t k = 0; k < 3; ++k)
          EXPECT_EQ(begun[k], mesh->triangles[triangle][(k + turn) % 3]);
      }
    EXPECT_EQ(seen.size(), mesh->triangles.size());
  }
  // A closed mesh has few triangles without a partner.
  EXPECT_LT(static_cast<double>(pair_triangles(ball).size()),
            0.56 * static_cast<double>(ball.triangles.size()));
}

TEST(WideBvh, FindsTheSameHitsAsBruteForce) {
  const std::vector<WideBvh::Geometry> parts{{scattered_triangles(700, 1), 3},
                                             {scattered_triangles(500, 2), 7}};
  const WideBvh tree(parts);
  RandomStream random{RandomKey(3)};
  int found = 0;
  for (int i = 0; i < 4000; ++i) {
    Ray ray{point(random) * 1.5f, direction(random)};
    // Also along the axes, and from so far away that the planes of boxes are rounded.
    if (i % 10 == 0) ray.direction = Vec3f(0.0f), ray.direction[i / 10 % 3] = i % 20 ? 1.f : -1.f;
    if (i % 10 == 1) ray.origin -= ray.direction * 30;
    const Nearest wanted = brute_force(parts, ray);
    BvhTraversal search(tree, ray, kFar, BvhTraversal::Query::closest);
    search.run();
    ASSERT_EQ(search.hit(), wanted.distance < 1e30) << i;
    if (!search.hit()) continue;
    ++found;
    EXPECT_EQ(search.geometry(), wanted.part);
    EXPECT_EQ(search.triangle(), wanted.triangle) << i;
    EXPECT_NEAR(static_cast<double>(search.distance()), wanted.distance,
                2e-5 * (1 + wanted.distance));
    const mesh::Mesh& mesh = *parts[search.geometry() == 3 ? 0 : 1].mesh;
    for (size_t k = 0; k < 3; ++k)
      EXPECT_EQ(search.corners()[k], mesh.positions[mesh.triangles[search.triangle()][k]]);

    const auto blocked = [&](double part) {
      BvhTraversal any(tree, ray, static_cast<float>(wanted.distance * part),
                       BvhTraversal::Query::any);
      any.run();
      return any.hit();
    };
    EXPECT_FALSE(blocked(0.999));
    EXPECT_TRUE(blocked(1.001));
  }
  EXPECT_GT(found, 1000);
}

TEST(WideBvh, LetsNoRayOutOfAClosedMesh) {
  const auto ball = std::make_shared<mesh::Mesh>(mesh::sphere_mesh(Vec3d(0), 1, 5));
  const WideBvh tree({{ball, 0}});
  RandomStream random{RandomKey(4)};
  for (int i = 0; i < 200000; ++i) {
    // Towards corners and edges, where triangles meet.
    const mesh::Triangle& t =
        ball->triangles[random.below(static_cast<uint32_t>(ball->triangles.size()))];
    const float part = i % 2 ? 0 : static_cast<float>(random.uniform());
    const Vec3f at = ball->positions[t[0]] * (1 - part) + ball->positions[t[1]] * part;
    const Vec3f from = point(random) * 0.5f;
    BvhTraversal search(tree, {from, normalized(at - from)}, kFar, BvhTraversal::Query::closest);
    search.run();
    ASSERT_TRUE(search.hit()) << i;
  }
}

TEST(WideBvh, HandlesNoneOneAndManyAtOnePlace) {
  const Ray down{{0.2f, 1, 0.2f}, {0, -1, 0}};
  const auto hits = [&](const WideBvh& tree) {
    BvhTraversal search(tree, down, kFar, BvhTraversal::Query::closest);
    search.run();
    return search.hit();
  };
  EXPECT_FALSE(hits(WideBvh()));
  EXPECT_FALSE(hits(WideBvh(std::vector<WideBvh::Geometry>())));
  auto mesh = std::make_shared<mesh::Mesh>();
  mesh->positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
  mesh->triangles = {{0, 1, 2}};
  EXPECT_TRUE(hits(WideBvh({{mesh, 0}})));
  mesh->triangles.assign(5000, {0, 1, 2});
  EXPECT_TRUE(hits(WideBvh({{mesh, 0}})));
  mesh->triangles.assign(3, {0, 0, 0});  // no area
  EXPECT_FALSE(hits(WideBvh({{mesh, 0}})));
}

TEST(WideBvh, IsTheSameForAnyNumberOfThreads) {
  const std::vector<WideBvh::Geometry> parts{{scattered_triangles(20000, 5), 0}};
  const auto trace_all = [&](int threads) {
    return with_threads(threads, [&] {
      const WideBvh tree(parts);
      std::vector<std::pair<uint32_t, float>> all;
      RandomStream random{RandomKey(6)};
      for (int i = 0; i < 2000; ++i) {
        const Vec3f from = point(random);
        BvhTraversal search(tree, {from, direction(random)}, kFar, BvhTraversal::Query::closest);
        search.run();
        all.emplace_back(search.hit() ? search.triangle() : ~0u, search.distance());
      }
      return std::pair(tree.bytes(), all);
    });
  };
  EXPECT_EQ(trace_all(1), trace_all(7));
}

TEST(PathScheduler, GivesTheResultsOfALoop) {
  const WideBvh tree({{scattered_triangles(2000, 7), 0}});
  // Paths of different lengths that turn at each hit.
  const auto path = [&](size_t index) {
    RandomStream random{RandomKey(index)};
    Vec3f at = point(random);
    float length = 0;
    for (size_t k = 0; k <= index % 13; ++k) {
      const Vec3f way = direction(random);
      const auto aim = k % 3 == 2 ? BvhTraversal::Query::any : BvhTraversal::Query::closest;
      BvhTraversal search(tree, {at, way}, 1, aim);
      finish(search);
      length += search.hit() ? 0.5f * search.distance() : 1;
      at += way * (0.5f * search.distance());
    }
    return length;
  };
  for (const size_t count : {0u, 1u, 5u, 16u, 1000u}) {
    std::array<float, kMaxInFlight> results{};
    std::vector<float> in_order;
    run_interleaved(
        count, [&](size_t i) { results[i % kMaxInFlight] = path(i); },
        [&](size_t i) {
          EXPECT_EQ(i, in_order.size());
          in_order.push_back(results[i % kMaxInFlight]);
        });
    ASSERT_EQ(in_order.size(), count);
    std::vector<float> parallel(count);
    parallel_interleaved(count, [&](size_t i) { parallel[i] = path(i); });
    for (size_t i = 0; i < count; ++i) {
      EXPECT_EQ(in_order[i], path(i));
      EXPECT_EQ(parallel[i], path(i));
    }
  }
}

struct Level {
  const Level* above;
  std::array<char, 512> own{};
};
/// Recurses this many levels, all of which stay on the stack, and counts them there.
size_t recurse(size_t levels, const Level* above = nullptr) {
  const Level level{above};
  if (levels > 1) return recurse(levels - 1, &level);
  size_t count = 0;
  for (const Level* at = &level; at; at = at->above) ++count;
  return count;
}

TEST(PathScheduler, PathsHaveStacksAsLargeAsThreads) {
  std::array<size_t, kMaxInFlight> depths{};
  run_interleaved(
      kMaxInFlight, [&](size_t i) { depths[i] = recurse(5000); }, [](size_t) {});
  EXPECT_THAT(depths, testing::Each(5000u));
}

TEST(PathScheduler, WorkMayThrowAndCatch) {
  const WideBvh tree({{scattered_triangles(2000, 7), 0}});
  // With arrays on the stack, which the address sanitizer guards, and other paths' turns in
  // between.
  const auto work = [&](size_t i, const auto& deeper) -> float {
    std::array<float, 50> own;
    own.fill(static_cast<float>(i));
    RandomStream random{RandomKey(i)};
    const Vec3f from = point(random);
    BvhTraversal search(tree, {from, direction(random)}, kFar, BvhTraversal::Query::closest);
    finish(search);
    if (i % 7 == 0) throw std::runtime_error("enough");
    try {
      own[i % 50] = deeper(i - 1, deeper);
    } catch (const std::runtime_error&) {
      own[i % 50] = search.distance();
    }
    return std::accumulate(own.begin(), own.end(), 0.f);
  };
  const auto caught = [&](size_t i) { return i % 7 == 0 ? 0 : work(i, work); };
  std::vector<float> results(1000);
  run_interleaved(
      results.size(), [&](size_t i) { results[i] = caught(i); }, [](size_t) {});
  for (size_t i = 0; i < results.size(); ++i) EXPECT_EQ(results[i], caught(i));
}

TEST(PathScheduler, PropagatesExceptions) {
  const WideBvh tree({{scattered_triangles(2000, 7), 0}});
  const auto look = [&](size_t i) {
    RandomStream random{RandomKey(i)};
    const Vec3f from = point(random);
    BvhTraversal search(tree, {from, direction(random)}, kFar, BvhTraversal::Query::closest);
    finish(search);
  };
  std::vector<size_t> came_back;
  const auto work = [&](size_t i) {
    look(i);
    if (i == 40) throw std::runtime_error("no more");
    look(i);
  };
  EXPECT_THROW(run_interleaved(1000, work, [&](size_t i) { came_back.push_back(i); }),
               std::runtime_error);
  std::vector<size_t> before(40);
  std::iota(before.begin(), before.end(), size_t{0});
  EXPECT_EQ(came_back, before);
  EXPECT_THROW(run_interleaved(1000, look, [](size_t) { throw std::runtime_error("full"); }),
               std::runtime_error);
  // And the scheduler works as before.
  came_back.clear();
  run_interleaved(100, look, [&](size_t i) { came_back.push_back(i); });
  EXPECT_EQ(came_back.size(), 100u);
}

}  // namespace
}  // namespace vug::raytree
