// SPDX-License-Identifier: Apache-2.0
// The edges of a polygon that are selected near some points contain all that matter there.
#include <vug/base/rng.h>
#include <vug/passages/polygon_edges.h>
#include <vug/passages/polygon_section.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vug::passages {
namespace {

std::vector<Vec2d> random_star(size_t corners, double size, RandomStream& random) {
  std::vector<Vec2d> out;
  for (size_t i = 0; i < corners; ++i) {
    const double angle = 2 * kPi * static_cast<double>(i) / static_cast<double>(corners);
    out.push_back(Vec2d(std::cos(angle), std::sin(angle)) * (size * random.uniform(0.5, 1.0)));
  }
  return out;
}

std::vector<Edge> edges_of(const std::vector<Vec2d>& outline) {
  std::vector<Edge> edges;
  for (size_t i = 0; i < outline.size(); ++i)
    edges.emplace_back(outline[i], outline[(i + 1) % outline.size()]);
  return edges;
}

double distance(const Edge& edge, const Vec2d& p) {
  const Vec2d from = p - edge.a;
  return (from - edge.along * std::clamp(from.dot(edge.along) * edge.inverse, 0.0, 1.0)).length();
}

TEST(PolygonEdges, SelectionsContainTheNearestEdgesAndAllCrossings) {
  RandomStream random(RandomKey(50));
  size_t selected = 0, all = 0;
  for (const double size : {1e-3, 3.0, 1e4})
    for (const size_t corners : {12u, 41u, 48u, 256u}) {
      const std::vector<Edge> edges = edges_of(random_star(corners, size, random));
      const EdgeLanes lanes(edges);
      ASSERT_FALSE(lanes.empty());
      for (int i = 0; i < 200; ++i) {
        const auto coordinate = [&](double most) { return random.uniform(-most, most) * size; };
        PlaneRectangle box{{coordinate(1.5), coordinate(1.5)}, {0, 0}};
        const double extent = i % 4 == 0 ? 0 : 0.1;
        box.half = {std::fabs(coordinate(extent)), std::fabs(coordinate(extent))};
        std::vector<size_t> near;
        std::set<size_t> crossed;
        lanes.select(box).visit([&](size_t n) { near.push_back(n); },
                                [&](size_t n) { crossed.insert(n); });
        EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
        selected += near.size();
        all += corners;
        for (int k = 0; k < 20; ++k) {
          const Vec2d p =
              box.centre + box.half * Vec2d(random.uniform(-1, 1), random.uniform(-1, 1));
          size_t nearest = 0;
          for (size_t n = 1; n < corners; ++n)
            if (distance(edges[n], p) < distance(edges[nearest], p)) nearest = n;
          const auto is_near = [&](size_t n) {
            return std::count(near.begin(), near.end(), n) > 0;
          };
          ASSERT_TRUE(is_near(nearest)) << corners << " " << p;
          for (size_t n = 0; n < corners; ++n) {
            const auto [low, high] = std::minmax(edges[n].a.y, edges[n].b.y);
            if (low <= p.y && p.y < high) {
              ASSERT_TRUE(is_near(n) || crossed.count(n)) << corners << " " << p;
            }
          }
        }
      }
    }
  EXPECT_LT(selected, all / 4);
}

TEST(PolygonEdges, FewAndVeryManyEdgesAreNotSelected) {
  RandomStream random(RandomKey(51));
  for (const size_t corners : {3u, 11u, 257u})
    EXPECT_TRUE(EdgeLanes(edges_of(random_star(corners, 1, random))).empty()) << corners;
}

TEST(PolygonEdges, SectionsHaveTheDistanceToAllEdges) {
  RandomStream random(RandomKey(52));
  for (const size_t corners : {5u, 12u, 48u, 300u}) {
    const std::vector<Vec2d> outline = random_star(corners, 4, random);
    const std::vector<Edge> edges = edges_of(outline);
    const SectionPtr section = polygon_section(outline);
    for (int i = 0; i < 300; ++i) {
      float u[Pack::kLanes], v[Pack::kLanes], values[Pack::kLanes];
      const double u0 = random.uniform(-6, 6), v0 = random.uniform(-6, 6);
      for (size_t lane = 0; lane < Pack::kLanes; ++lane) {
        u[lane] = static_cast<float>(u0 + 0.1 * static_cast<double>(lane));
        v[lane] = static_cast<float>(v0 - 0.05 * static_cast<double>(lane));
      }
      const Pack packed_u = Pack::load(u), packed_v = Pack::load(v);
      Pack packed;
      section->distances(&packed_u, &packed_v, 1, &packed);
      packed.store(values);
      for (size_t lane = 0; lane < Pack::kLanes; ++lane) {
        const Vec2d p(static_cast<double>(u[lane]), static_cast<double>(v[lane]));
        double least = kInfinity;
        bool inside = false;
        for (const Edge& edge : edges) {
          least = std::min(least, distance(edge, p));
          if ((edge.a.y > p.y) != (edge.b.y > p.y) &&
              p.x < edge.a.x + edge.along.x * (p.y - edge.a.y) / edge.along.y)
            inside = !inside;
        }
        const double expected = inside ? -least : least;
        ASSERT_NEAR(section->distance(p.x, p.y), expected, 1e-12) << corners << " " << p;
        ASSERT_NEAR(static_cast<double>(values[lane]), expected, 2e-5) << corners << " " << p;
      }
    }
  }
}

}  // namespace
}  // namespace vug::passages
