// SPDX-License-Identifier: Apache-2.0
// Distances of each primitive at points where they can be calculated by hand.
#include <vug/field/registry.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::field {
namespace {

using Params = std::vector<std::pair<std::string, Value>>;
struct Oracle {
  std::string kind;
  Params params;
  Vec3d at;
  double distance;
};

TEST(Primitive, DistancesCalculatedByHand) {
  const double root2 = std::sqrt(2.0), root3 = std::sqrt(3.0), root5 = std::sqrt(5.0);
  const Params box = {{"size", Vec3d(2, 4, 6)}},
               soft = {{"size", Vec3d(2, 4, 6)}, {"rounding", 0.5}};
  const Params cylinder = {{"radius", 1.0}, {"height", 4.0}};
  const Params cone = {{"radius", 1.0}, {"height", 2.0}};
  const Params capped = {{"bottom", 2.0}, {"top", 1.0}, {"height", 2.0}};
  const Params rod = {{"a", Vec3d(0, 0, 0)}, {"b", Vec3d(3, 0, 0)}, {"radius", 0.5}};
  // sine = (2 - 1) / 2: the slant leaves the axis at 30 degrees.
  const Params tapered = {
      {"a", Vec3d(0)}, {"b", Vec3d(0, 2, 0)}, {"radius_a", 2.0}, {"radius_b", 1.0}};
  const Params ring = {{"radius", 2.0}, {"tube", 0.5}};
  const Params pyramid = {{"base", 2.0}, {"height", 1.0}};
  const Params wedge = {{"size", Vec3d(2, 2, 4)}};
  const Params hexagon = {{"sides", 6}, {"radius", 1.0}, {"height", 2.0}};
  const Oracle oracles[] = {
      {"box", box, {0, 0, 0}, -1},
      {"box", box, {4, 0, 0}, 3},
      {"box", box, {4, 6, 3}, 5},
      {"box", soft, {1, 2, 3}, (root3 - 1) * 0.5},
      {"box", soft, {0, 0, 0}, -1},
      {"cylinder", cylinder, {0, 0, 0}, -1},
      {"cylinder", cylinder, {3, 0, 4}, 4},
      {"cylinder", cylinder, {0, 5, 0}, 3},
      {"cylinder", cylinder, {0, 5, 5}, 5},
      {"cone", cone, {0, 1, 0}, 0},
      {"cone", cone, {0, 4, 0}, 3},
      {"cone", cone, {0, -3, 0}, 2},
      {"cone", cone, {2, 0.75, 0}, (4 + 0.75 - 1) / root5},  // line 2x + y = 1
      {"cone", cone, {4, -5, 0}, 5},
      {"cone", cone, {0, 0, 0}, -1 / root5},
      {"capped_cone", capped, {0, 3, 0}, 2},
      {"capped_cone", capped, {5, -5, 0}, 5},
      {"capped_cone", capped, {0, 0, 3.5}, 4 / root5},  // line 2r + y = 3
      {"capped_cone", capped, {0, 0, 0}, -1},
      {"capsule", rod, {0, 1, 0}, 0.5},
      {"capsule", rod, {7, 3, 0}, 4.5},
      {"capsule", rod, {1, 0, 0}, -0.5},
      {"capsule", {{"radius", 1.0}, {"height", 2.0}}, {0, 3, 0}, 1},
      {"tapered_capsule", tapered, {0, -5, 0}, 3},
      {"tapered_capsule", tapered, {0, 5, 0}, 2},
      {"tapered_capsule", tapered, {4, 3, 0}, 4 * root3 / 2 + 1.5 - 2},
      {"torus", ring, {0, 0, 0}, 1.5},
      {"torus", ring, {2, 0, 0}, -0.5},
      {"torus", ring, {5, 4, 0}, 4.5},
      {"pyramid", pyramid, {0, 2.5, 0}, 2},
      {"pyramid", pyramid, {0, -1.5, 0}, 1},
      {"pyramid", pyramid, {2, 1, 0}, 2.5 / root2},  // face x + y = 1/2
      {"pyramid", pyramid, {1, 1.5, 1}, std::sqrt(8.0 / 3)},
      {"pyramid", pyramid, {4, -0.5, 5}, 5},
      {"wedge", wedge, {0, 0, 0}, 0},
      {"wedge", wedge, {1, 1, 0}, root2},
      {"wedge", wedge, {-2, 0, 0}, 1},
      {"wedge", wedge, {4, -1, 6}, 5},
      {"wedge", wedge, {-0.5, -0.5, 0}, -0.5},
      {"prism", hexagon, {2, 0, 0}, 2 - root3 / 2},
      {"prism", hexagon, {0, 0, 3}, 2},
      {"prism", hexagon, {0, 3, 0}, 2},
      {"prism", hexagon, {0, 0, 0}, -root3 / 2},
      {"prism", {{"sides", 4}, {"radius", root2}, {"height", 8.0}}, {4, 0, 5}, 5},
      {"half_space", {{"normal", Vec3d(0, 3, 4)}, {"offset", 1.0}}, {7, 5, 5}, 6},
      {"slab", {{"normal", Vec3d(0, 0, 2)}, {"thickness", 1.0}}, {0, 0, -3}, 2.5},
      {"gyroid", {{"period", 1.0}, {"thickness", 0.1}}, {0, 0, 0}, -0.05},
      {"gyroid",
       {{"period", 1.0}, {"thickness", 0.1}},
       {0.125, 0.125, 0.125},
       1.5 / (2 * kPi * root3) - 0.05},
      {"ellipsoid", {{"radii", Vec3d(3, 2, 1)}}, {5, 0, 0}, 2},
      {"ellipsoid", {{"radii", Vec3d(3, 2, 1)}}, {0, 0, 0}, -1},
      {"ellipsoid", {{"radii", Vec3d(3, 2, 1)}}, {0, -4, 0}, 2},
      {"ellipsoid", {{"radii", Vec3d(2, 2, 2)}}, {0, 3, 4}, 3},
      // The point of the ellipse (2, 1) nearest to (1, 0) is (4/3, sqrt(5)/3), at sqrt(6)/3.
      {"ellipsoid", {{"radii", Vec3d(2, 1, 5)}}, {1, 0, 0}, -std::sqrt(6.0) / 3},
      {"empty", {}, {0, 0, 0}, 1e6},
  };
  for (const Oracle& o : oracles)
    EXPECT_NEAR(make(o.kind, o.params).value(o.at), o.distance, 1e-12) << o.kind << " at " << o.at;
}

/// Volume of {f < 0} from the midpoints of a lattice of about n^3 cells, each counted as a whole.
/// The three counts are coprime, so that no face runs through a row of midpoints.
double lattice_volume(const Field& field, int n) {
  const Box3d& box = field.bounds();
  const Vec3d cell = box.size() / Vec3d(n - 1, n, n + 1);
  int64_t inside = 0;
  for (int i = 0; i < n - 1; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n + 1; ++k)
        inside += field.value(box.min + cell * Vec3d(i + 0.5, j + 0.5, k + 0.5)) < 0;
  return static_cast<double>(inside) * cell.x * cell.y * cell.z;
}

TEST(Primitive, VolumesOfClassicSolids) {
  const double root3 = std::sqrt(3.0);
  const struct {
    std::string kind;
    Params params;
    double volume;
  } oracles[] = {
      {"sphere", {{"radius", 1.0}}, 4 * kPi / 3},
      {"ellipsoid", {{"radii", Vec3d(3, 2, 1)}}, 8 * kPi},
      {"box", {{"size", Vec3d(1, 2, 3)}}, 6},
      {"cylinder", {{"radius", 1.0}, {"height", 2.0}}, 2 * kPi},
      {"cone", {{"radius", 1.0}, {"height", 3.0}}, kPi},
      {"capped_cone", {{"bottom", 2.0}, {"top", 1.0}, {"height", 3.0}}, 7 * kPi},
      {"capsule", {{"radius", 1.0}, {"height", 2.0}}, 2 * kPi + 4 * kPi / 3},
      {"torus", {{"radius", 2.0}, {"tube", 0.5}}, kPi * kPi},
      {"pyramid", {{"base", 2.0}, {"height", 3.0}}, 4},
      {"wedge", {{"size", Vec3d(1, 2, 3)}}, 3},
      {"prism", {{"sides", 6}, {"radius", 1.0}, {"height", 2.0}}, 3 * root3},
      {"prism", {{"sides", 3}, {"radius", 1.0}, {"height", 4.0}}, 3 * root3},
  };
  for (const auto& o : oracles) {
    EXPECT_NEAR(lattice_volume(make(o.kind, o.params), 64) / o.volume, 1, 0.01) << o.kind;
  }
}

TEST(Primitive, SteinmetzSolidAndLens) {
  const Field along_y = make("cylinder", {{"radius", 1.0}, {"height", 4.0}});
  const Field along_x = make("rotate", {{"field", as_value(along_y)},
                                        {"axis", Vec3d(0, 0, 1)},
                                        {"angle", Number{kPi / 2, Dimension::angle}}});
  const Field both = make("intersection", {{"of", List{as_value(along_y), as_value(along_x)}}});
  EXPECT_NEAR(lattice_volume(both, 64), 16.0 / 3, 0.05);

  // Unit balls at distance 1: pi (4 + 1) (2 - 1)^2 / 12.
  const auto ball = [](double x) {
    return as_value(make("translate", {{"field", as_value(make("sphere", {{"radius", 1.0}}))},
                                       {"by", Vec3d(x, 0, 0)}}));
  };
  const Field lens = make("intersection", {{"of", List{ball(-0.5), ball(0.5)}}});
  EXPECT_NEAR(lattice_volume(lens, 64), 5 * kPi / 12, 0.03);
}

TEST(Primitive, APathIsTheUnionOfItsSegments) {
  const std::vector<Vec3d> path = {Vec3d(0), Vec3d(1, 0, 0), Vec3d(2, 1, 0), Vec3d(1, 2, 1)};
  const std::vector<double> radii = {0.2, 0.3, 0.1, 0.4};
  List points, sizes, rods, cones;
  for (size_t i = 0; i < path.size(); ++i) {
    points.emplace_back(path[i]);
    sizes.emplace_back(radii[i]);
    if (i == 0) continue;
    rods.push_back(
        as_value(make("capsule", {{"a", path[i - 1]}, {"b", path[i]}, {"radius", 0.2}})));
    cones.push_back(as_value(make(
        "tapered_capsule",
        {{"a", path[i - 1]}, {"b", path[i]}, {"radius_a", radii[i - 1]}, {"radius_b", radii[i]}})));
  }
  const std::pair<Field, Field> pairs[] = {
      {make("capsule", {{"path", points}, {"radius", 0.2}}), make("union", {{"of", rods}})},
      {make("tapered_capsule", {{"path", points}, {"radii", sizes}}),
       make("union", {{"of", cones}})}};
  for (const auto& [along, whole] : pairs) {
    EXPECT_EQ(along.lipschitz(), 1);
    EXPECT_EQ(along.exactness(), Exactness::eikonal);
    EXPECT_EQ(along.bounds(), whole.bounds());
    for (int i = 0; i < 500; ++i) {
      const Vec3d p(0.005 * i, 0.3 - 0.004 * i, 0.002 * i);
      EXPECT_EQ(along.value(p), whole.value(p));
      EXPECT_EQ(along.gradient(p).gradient, whole.gradient(p).gradient);
    }
  }
  EXPECT_NEAR(pairs[0].first.value({0.5, 1, 0}), 0.8, 1e-12);
  const Field line = make("capsule", {{"path", List{path[0], path[1]}}});
  EXPECT_EQ(line.exactness(), Exactness::exact);
}

TEST(Primitive, FaultsBetweenParametersAreSentences) {
  const struct {
    std::string kind;
    Params params;
  } faulty[] = {
      {"box", {{"size", Vec3d(1, 2, 3)}, {"rounding", 0.6}}},
      {"cylinder", {{"radius", 1.0}, {"height", 1.0}, {"rounding", 0.6}}},
      {"capped_cone", {{"bottom", 0.0}, {"top", 0.0}}},
      {"capsule", {{"a", Vec3d(0)}}},
      {"capsule", {{"path", List{Vec3d(0)}}}},
      {"capsule", {{"path", List{}}}},
      {"capsule", {{"path", List{Vec3d(0), Vec3d(1)}}, {"a", Vec3d(0)}, {"b", Vec3d(1)}}},
      {"tapered_capsule", {{"radius_a", 3.0}}},
      {"tapered_capsule", {{"path", List{Vec3d(0), Vec3d(1)}}}},
      {"tapered_capsule", {{"path", List{Vec3d(0), Vec3d(1)}}, {"radii", List{0.1}}}},
      {"tapered_capsule", {{"path", List{Vec3d(0), Vec3d(1)}}, {"radii", List{0.1, 3.0}}}},
      {"torus", {{"radius", 1.0}, {"tube", 1.5}}},
      {"half_space", {{"normal", Vec3d(0)}}},
      {"slab", {{"normal", Vec3d(0)}}},
      {"gyroid", {{"period", 1.0}, {"thickness", 0.3}}},
      {"prism", {{"sides", 2}}},
  };
  for (const auto& f : faulty) EXPECT_THROW(make(f.kind, f.params), Error) << f.kind;
}

}  // namespace
}  // namespace vug::field
