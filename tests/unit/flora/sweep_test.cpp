// SPDX-License-Identifier: Apache-2.0
// The field and the mesh of a swept stem show the same surface and keep their guarantees.
#include "stems.h"

#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/flora/sweep_field.h>
#include <vug/flora/sweep_mesh.h>
#include <vug/mesh/distance.h>
#include <vug/mesh/topology.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::flora {
namespace {

struct Case {
  const char* name;
  std::vector<Tube> tubes;
  double voxel;  ///< Voxel size in metres that a scene would use.
  size_t pieces;
};

std::vector<Case> cases() {
  lsystem::Drawing both;
  both.axes = {bent_culm(), folded_branch()};
  lsystem::Drawing cut;
  cut.axes = {bent_culm(0.9, 0.05, 3, 0.2)};
  cut.axes[0].nodes.erase(cut.axes[0].nodes.begin());  // Cut between nodes at both ends.
  lsystem::Drawing ends;                               // The open chambers are not visible.
  ends.axes = {bent_culm(0.9, 0.05, 3, 0.2)};
  ends.axes[0].nodes[2].along = 0.898;
  lsystem::Drawing pipe = cut;
  pipe.axes[0].nodes.clear();
  return {{"culm and branch", tubes(both, plain_sweep()), 2e-3, 2},
          {"hollow culm", tubes(cut, hollow_sweep()), 2e-3, 4},
          {"cut culm", tubes(cut, open_sweep()), 2e-3, 2},
          {"wall that keeps its thickness", tubes(cut, thick_sweep()), 2e-3, 2},
          {"cut at its nodes", tubes(ends, open_sweep()), 2e-3, 3},
          {"pipe", tubes(pipe, open_sweep()), 2e-3, 1}};
}

Vec3d random_in(const Box3d& box, RandomStream& random) {
  Vec3d p;
  for (int axis = 0; axis < 3; ++axis) p[axis] = random.uniform(box.min[axis], box.max[axis]);
  return p;
}

TEST(Sweep, MeshIsClosedAndManifold) {
  for (const Case& c : cases()) {
    const mesh::Mesh mesh = swept_mesh(c.tubes);
    mesh::validate(mesh, c.name);
    const mesh::Topology topology = mesh::inspect(mesh);
    EXPECT_TRUE(topology.closed()) << c.name;
    EXPECT_EQ(topology.misoriented_edges, 0u) << c.name;
    EXPECT_EQ(topology.nonmanifold_vertices, 0u) << c.name;
    EXPECT_EQ(topology.degenerate_triangles, 0u) << c.name;
    EXPECT_EQ(topology.unused_vertices, 0u) << c.name;
    EXPECT_EQ(topology.components, c.pieces) << c.name;
    EXPECT_EQ(topology.genus, std::string(c.name) == "pipe" ? 1u : 0u) << c.name;
  }
}

TEST(Sweep, FieldAndMeshDifferByLessThanHalfAVoxel) {
  for (const Case& c : cases()) {
    const mesh::Mesh mesh = swept_mesh(c.tubes);
    const field::Field field = swept(c.tubes);
    const mesh::MeshDistance distance(mesh);
    double slope = 1;
    for (const Tube& tube : c.tubes) slope = std::max(slope, tube.slope());
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto [a, b, d] = mesh::corners(mesh, t);
      const Vec3d middle = (a + b + d) / 3;
      ASSERT_LE(std::fabs(field.value(middle)) * slope, 0.5 * c.voxel) << c.name << " " << middle;
    }
    // And at the zero set of the field.
    RandomStream random(RandomKey(3).at(c.name));
    int met = 0;
    for (int ray = 0; ray < 20000 && met < 400; ++ray) {
      Vec3d p = random_in(grown(mesh::bounds(mesh), 0.05), random);
      const Vec3d way = random_in(Box3d(Vec3d(-1), Vec3d(1)), random).normalized();
      for (int step = 0; step < 400; ++step) {
        const double value = field.value(p);
        if (std::fabs(value) < 1e-7) {
          ++met;
          ASSERT_LE(std::fabs(distance.signed_distance(p)), 0.5 * c.voxel) << c.name << " " << p;
          break;
        }
        p += way * std::fabs(value);
        if (value > 5) break;
      }
    }
    EXPECT_GT(met, 100) << c.name;
  }
}

TEST(Sweep, SignMatchesTheMesh) {
  for (const Case& c : cases()) {
    if (c.tubes.size() > 1) continue;  // Overlapping stems do not form one closed mesh.
    const mesh::Mesh mesh = swept_mesh(c.tubes);
    const field::Field field = swept(c.tubes);
    const mesh::MeshDistance distance(mesh);
    RandomStream random(RandomKey(4).at(c.name));
    int inside = 0;
    for (int i = 0; i < 4000; ++i) {
      const Vec3d p = random_in(grown(mesh::bounds(mesh), 0.02), random);
      const double d = distance.signed_distance(p);
      inside += d < 0;
      if (std::fabs(d) > 0.5 * c.voxel) {
        ASSERT_EQ(field.value(p) < 0, d < 0) << c.name << " at " << p << " distance " << d;
      }
      ASSERT_LE(std::fabs(field.value(p)), std::fabs(d) + 0.5 * c.voxel) << c.name << " at " << p;
    }
    EXPECT_GT(inside, 20) << c.name;
  }
}

TEST(Sweep, FieldRespectsItsLipschitzBound) {
  for (const Case& c : cases()) {
    const field::Field field = swept(c.tubes);
    RandomStream random(RandomKey(5).at(c.name));
    const mesh::Mesh mesh = swept_mesh(c.tubes);
    for (int i = 0; i < 20000; ++i) {
      // Near the surface, around displacement, mitred bends and walls.
      const auto v = random.below(static_cast<uint32_t>(mesh.positions.size()));
      const double reach = i % 3 == 0 ? 0.3 : i % 3 == 1 ? 0.03 : 0.004;
      const Vec3d p = Vec3d(mesh.positions[v]) + random_in({Vec3d(-reach), Vec3d(reach)}, random);
      const Vec3d q = p + random_in({Vec3d(-0.1 * reach), Vec3d(0.1 * reach)}, random);
      ASSERT_LE(std::fabs(field.value(p) - field.value(q)), (p - q).length() * 1.0001 + 1e-9)
          << c.name << " between " << p << " and " << q;
    }
  }
}

TEST(Sweep, GradientMatchesDifferences) {
  for (const Case& c : cases()) {
    const field::Field field = swept(c.tubes);
    RandomStream random(RandomKey(7).at(c.name));
    const mesh::Mesh mesh = swept_mesh(c.tubes);
    int creases = 0;
    constexpr int kPoints = 6000;
    for (int i = 0; i < kPoints; ++i) {
      const auto v = random.below(static_cast<uint32_t>(mesh.positions.size()));
      const double reach = i % 3 == 0 ? 0.3 : i % 3 == 1 ? 0.03 : 0.004;
      const Vec3d p = Vec3d(mesh.positions[v]) + random_in({Vec3d(-reach), Vec3d(reach)}, random);
      const field::Gradient told = field.gradient(p);
      ASSERT_EQ(told.value, field.value(p)) << c.name << " at " << p;
      // One-sided differences; if they disagree there is a crease between them.
      constexpr double kStep = 1e-7;
      double off = 0, bend = 0;
      for (int axis = 0; axis < 3; ++axis) {
        Vec3d step(0);
        step[axis] = kStep;
        const double up = (field.value(p + step) - told.value) / kStep;
        const double down = (told.value - field.value(p - step)) / kStep;
        off = std::max(off, std::fabs(told.gradient[axis] - 0.5 * (up + down)));
        bend = std::max(bend, std::fabs(up - down));
      }
      if (bend > 1e-3)
        ++creases;
      else
        ASSERT_LT(off, 1e-3) << c.name << " at " << p;
      ASSERT_LE(told.gradient.length(), 1.0001) << c.name << " at " << p;
    }
    EXPECT_LT(creases, kPoints / 50) << c.name;
  }
}

TEST(Sweep, GrowsBeyondItsBox) {
  for (const Case& c : cases()) {
    const field::Field field = swept(c.tubes);
    RandomStream random(RandomKey(6).at(c.name));
    for (int i = 0; i < 2000; ++i) {
      const Vec3d p = random_in(grown(field.bounds(), 3), random);
      Vec3d off(0);
      for (int axis = 0; axis < 3; ++axis)
        off[axis] =
            std::max({field.bounds().min[axis] - p[axis], p[axis] - field.bounds().max[axis], 0.0});
      if (off.length() > 0) {
        ASSERT_GE(field.value(p), off.length() * (1 - 1e-6)) << c.name;
      }
    }
  }
}

TEST(Sweep, StaysInItsBoundingBox) {
  for (const Case& c : cases()) {
    Box3d box;
    for (const Tube& tube : c.tubes) box = united(box, tube.bounds());
    const Box3d shown = mesh::bounds(swept_mesh(c.tubes));
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(shown.min[axis], box.min[axis] - 1e-6) << c.name;
      EXPECT_LE(shown.max[axis], box.max[axis] + 1e-6) << c.name;
    }
    // And the box is tight to a tenth of the mesh's size.
    EXPECT_LT((box.size() - shown.size()).length(), 0.1 * shown.size().length()) << c.name;
  }
}

TEST(Sweep, RidgesHaveTheirHeight) {
  lsystem::Drawing drawing;
  drawing.axes = {bent_culm()};
  drawing.axes[0].nodes.front().along = 0.1;  // Keeps all nodes whole.
  const SweepOptions options = plain_sweep();
  const Tube tube = tubes(drawing, options).front();
  const mesh::Mesh mesh = swept_mesh({tube});
  for (const DisplacedNode& node : tube.displacement().nodes()) {
    for (const auto& [above, height] :
         {std::pair(0.0, options.displacement.scar),
          std::pair(options.displacement.ridge_above, options.displacement.ridge)}) {
      const double along = node.along + above * node.radius;
      const double wanted = tube.radius(along) + height * node.radius;
      EXPECT_NEAR(tube.displaced(along, 2), wanted, 1e-12);
      double most = 0;
      for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const Tube::Coordinates coords = tube.coordinates(Vec3d(mesh.positions[i]), 0);
        if (std::fabs(coords.along - along) < 0.01 * node.radius)
          most = std::max(most, coords.radial);
      }
      EXPECT_NEAR(most, wanted, 0.02 * wanted);
    }
    if (node.angles.empty()) continue;
    const double above =
        node.along + 0.3 * options.displacement.groove_length * (node.next - node.along);
    const double bed = tube.radius(above) - tube.displaced(above, node.angles[0]);
    EXPECT_NEAR(bed, options.displacement.groove * node.radius, 1e-12);
    EXPECT_EQ(tube.displaced(above, node.angles[0] + 1), tube.radius(above));
  }
}

TEST(Sweep, WallsHaveTheirRelativeAndMinimumThickness) {
  lsystem::Drawing drawing;
  drawing.axes = {bent_culm()};  // From 4 cm to 4 mm.
  SweepOptions options;
  options.wall = 0.25;
  options.min_wall = 0.009;
  const Tube tube = tubes(drawing, options).front();
  for (double along = 0.01; along < 3; along += 0.01) {
    const double r = tube.radius(along), wall = r - tube.inner_radius(along);
    EXPECT_NEAR(wall, std::min(std::max(0.25 * r, 0.009), 0.9 * r), 1e-12);
  }
  options.min_wall = -1;
  EXPECT_NE(options.fault(), "");
}

// Wang et al.: on a planar curve the plane's normal is transported to itself, also at reversals.
TEST(Sweep, FramesDoNotTwistAtInflections) {
  for (const double sway : {0.3, -0.8}) {
    // Three bends with reversals in the x-y plane, rotated arbitrarily in space.
    const Vec3d axis = Vec3d(0.3, 0.8, -0.5).normalized();
    const auto put = [&](const Vec3d& v) { return rotated(v, axis, 1.1); };
    lsystem::Axis culm;
    constexpr int kStations = 90;
    Frame frame = Frame{put({0, 1, 0}), put({0, 0, 1}), Vec3d(0)}.orthonormalized();
    double along = 0;
    Vec3d before(0);
    for (int i = 0; i <= kStations; ++i) {
      const double t = 3.0 * i / kStations, bend = sway * std::sin(2.5 * t);
      const Vec3d at = put({sway / 2.5 * (1 - std::cos(2.5 * t)), t, 0});
      if (i > 0) along += (at - before).length();
      frame = transported(frame, before, at,
                          put({std::sin(std::atan(bend)), std::cos(std::atan(bend)), 0}));
      before = at;
      culm.stations.push_back({at, frame, 0.03 * (1 - 0.5 * i / kStations), along, 1});
    }
    const auto tube = Tube::make(culm, 0, {});
    ASSERT_TRUE(tube);
    const Vec3d normal = put({0, 0, 1});
    for (const Ring& ring : tube->rings()) {
      EXPECT_LT(ring.frame.normal.cross(normal).length(), 1e-6);
      EXPECT_GT(ring.frame.normal.dot(normal), 0);
    }
    // And between rings.
    for (double s = 0; s < along; s += 0.013)
      EXPECT_LT(tube->at(s).frame.normal.cross(normal).length(), 1e-6);
  }
}

TEST(Sweep, AttributesGiveThePositionOnThePlant) {
  lsystem::Drawing drawing;
  drawing.axes = {bent_culm()};
  const Tube tube = tubes(drawing, plain_sweep()).front();
  const mesh::Mesh mesh = swept_mesh({tube});
  const auto value = [&](const char* name, size_t i) {
    return static_cast<double>(mesh::find_attribute(mesh, name, 1)->values[i]);
  };
  for (size_t i = 0; i < mesh.positions.size(); i += 7) {
    const double along = tube.coordinates(Vec3d(mesh.positions[i]), 0).along;
    EXPECT_NEAR(value("along", i), along, 1e-5);
    if (along < 2.69) {
      EXPECT_NEAR(value("above_node", i) + value("below_node", i), 0.3, 1e-5);
    } else if (along > 2.71) {
      EXPECT_EQ(value("below_node", i), 1000);
    }
    EXPECT_NEAR(std::fabs(std::remainder(value("internode", i) - along / 0.3, 1)), 0, 1e-3);
    EXPECT_EQ(value("age", i), 3);
    EXPECT_EQ(value("order", i), 0);
  }
}

TEST(Sweep, MeshDoesNotDependOnThreads) {
  for (const Case& c : cases()) {
    const Digest alone = mesh::digest(swept_mesh(c.tubes));
    for (const int threads : {1, 2, 5, 8}) {
      with_threads(threads, [&] { EXPECT_EQ(mesh::digest(swept_mesh(c.tubes)), alone) << c.name; });
    }
  }
}

TEST(Sweep, NoTubesGiveTheEmptyField) {
  EXPECT_TRUE(swept({}).bounds().isEmpty());
  EXPECT_TRUE(swept_mesh({}).positions.empty());
}

}  // namespace
}  // namespace vug::flora
