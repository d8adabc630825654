// SPDX-License-Identifier: Apache-2.0
#include "solids.h"

#include <vug/base/parallel.h>
#include <vug/field/noise.h>
#include <vug/mesh/self_intersections.h>
#include <vug/mesh/topology.h>
#include <vug/meshing/project.h>

#include <gtest/gtest.h>

#include <atomic>

namespace vug::meshing {
namespace {

void expect_closed_outward(const mesh::Mesh& mesh) {
  const mesh::Topology topology = mesh::inspect(mesh);
  EXPECT_EQ(topology.boundary_edges, 0U);
  EXPECT_EQ(topology.nonmanifold_edges, 0U);
  EXPECT_EQ(topology.misoriented_edges, 0U);
  EXPECT_EQ(topology.degenerate_triangles, 0U);
  EXPECT_EQ(topology.unused_vertices, 0U);
  EXPECT_GT(volume_of(mesh), 0);
}

TEST(Polygonize, SolidsAreClosedAndTheirVerticesOnTheField) {
  std::vector<Solid> all = solids();
  all.push_back({"cut box", cut_box(), 0, 0});
  for (const Solid& solid : all) {
    SCOPED_TRACE(solid.name);
    const PolygonizeResult found = polygonized(solid.field, 0.05);
    expect_closed_outward(found.mesh);
    EXPECT_TRUE(mesh::self_intersections(found.mesh).empty());
    EXPECT_LT(found.report.rms_residual, 0.01);
    EXPECT_LE(found.report.max_move, 1.25 + 1e-6);
    EXPECT_EQ(found.mesh.normals.size(), found.mesh.positions.size());
    // The figures of the report, verified independently.
    double squares = 0;
    for (const Vec3f& p : found.mesh.positions) {
      const double distance = solid.field.value(Vec3d(p)) / 0.05;
      squares += distance * distance;
    }
    EXPECT_LT(std::sqrt(squares / static_cast<double>(found.mesh.positions.size())), 0.01);
    RecordProperty(std::string(solid.name) + "_backed_off",
                   static_cast<int>(found.report.shortened_moves));
  }
}

// Warped and displaced surfaces, which have no closed form, against the field in double precision.
TEST(Polygonize, VerticesOfRoughRockAreOnTheField) {
  constexpr double kVoxel = 0.08;
  const field::Field ball = field::make("sphere", {{"radius", 1.5}});
  const field::Field warped =
      field::make("warp", {{"field", field::as_value(ball)}, {"scale", 1.2}, {"amount", 0.25}});
  const field::Noise fbm = field::make_noise("fbm", {{"scale", 0.5}, {"octaves", 4}});
  const field::Field rock = field::make(
      "displace",
      {{"field", field::as_value(warped)}, {"noise", field::as_value(fbm)}, {"amount", 0.08}});
  const PolygonizeResult found = polygonized(rock, kVoxel);
  expect_closed_outward(found.mesh);
  double squares = 0;
  for (const Vec3f& p : found.mesh.positions) {
    const field::Gradient g = rock.gradient(Vec3d(p));
    const double distance = g.value / g.gradient.length() / kVoxel;
    squares += distance * distance;
  }
  const double rms = std::sqrt(squares / static_cast<double>(found.mesh.positions.size()));
  EXPECT_LT(rms, 0.01);
  EXPECT_NEAR(rms, found.report.rms_residual, kLargestError);
}

// Flat facets between points of the surface have an error of O(h^2), also on creases if these are
// preserved.
TEST(Polygonize, AreaAndVolumeConvergeAtSecondOrder) {
  for (const Solid& solid : solids()) {
    SCOPED_TRACE(solid.name);
    const mesh::Mesh coarse = polygonized(solid.field, 0.1).mesh;
    const mesh::Mesh fine = polygonized(solid.field, 0.025).mesh;
    const double area_ratio = (area(coarse) - solid.area) / (area(fine) - solid.area);
    const double volume_ratio =
        (volume_of(coarse) - solid.volume) / (volume_of(fine) - solid.volume);
    // Two halvings: 16 at second order, 4 at first, 64 at third.
    EXPECT_GT(area_ratio, 8);
    EXPECT_LT(area_ratio, 32);
    EXPECT_GT(volume_ratio, 8);
    EXPECT_LT(volume_ratio, 32);
    EXPECT_NEAR(area(fine) / solid.area, 1, 1e-3);
    EXPECT_NEAR(volume_of(fine) / solid.volume, 1, 1e-3);
  }
}

TEST(Polygonize, NormalsOfASphereAreExact) {
  const field::Field ball = field::make("sphere", {{"radius", 1.0}});
  const mesh::Mesh mesh = polygonized(ball, 0.1).mesh;
  for (size_t v = 0; v < mesh.positions.size(); ++v)
    EXPECT_LT((mesh.normals[v] - mesh.positions[v].normalized()).length(), 1e-5);
}

TEST(Polygonize, TheSameBytesForAnyNumberOfThreads) {
  const field::Field solid = cut_box();
  const Digest reference = mesh::digest(polygonized(solid, 0.08).mesh);
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads,
                 [&] { EXPECT_EQ(mesh::digest(polygonized(solid, 0.08).mesh), reference); });
  }
}

TEST(Polygonize, WorksWithoutTheField) {
  const field::Field solid = cut_box();
  volume::VoxelizeOptions voxels;
  voxels.voxel = 0.05;
  const mesh::Mesh mesh = polygonize(volume::voxelize(solid, voxels), nullptr).mesh;
  expect_closed_outward(mesh);
  EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
}

TEST(Polygonize, AdaptivityMakesFewerTriangles) {
  const field::Field solid = cut_box();
  PolygonizeOptions merged;
  merged.adaptivity = 0.5;
  const mesh::Mesh few = polygonized(solid, 0.04, merged).mesh;
  EXPECT_LT(few.triangles.size(), polygonized(solid, 0.04).mesh.triangles.size() / 2);
  EXPECT_EQ(mesh::inspect(few).boundary_edges, 0U);
}

TEST(Polygonize, OfAnEmptyFieldIsEmpty) {
  EXPECT_TRUE(polygonized(field::Field(), 0.1).mesh.positions.empty());
}

TEST(Polygonize, StopsWhenCancelled) {
  const field::Field ball = field::make("sphere", {{"radius", 1.0}});
  volume::VoxelizeOptions voxels;
  const volume::LevelSet level_set = volume::voxelize(ball, voxels);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(polygonize(level_set, &ball, {}, progress), Error);
}

/// A field that counts the repairs of folded polygons, which restrict it to balls of 8 voxels, and
/// cancels the work during the first one.
class CancelsRepair : public field::EvaluationModes<CancelsRepair> {
 public:
  CancelsRepair(field::NodePtr child, double voxel, Progress* progress)
      : EvaluationModes(child->traits()),
        child_(std::move(child)),
        voxel_(voxel),
        progress_(progress) {}
  template <class T>
  T at(const field::Point<T>& p) const {
    return child_->eval(p);
  }
  template <class T>
  void fill(const field::Point<field::Pack>* points, int count, T* out,
            field::Scratch& scratch) const {
    child_->eval(points, count, out, scratch);
  }
  field::Restriction restrict_to(const field::Ball& ball) const override {
    if (std::fabs(ball.radius - 8 * voxel_) < 1e-9) {
      ++repairs;
      if (progress_) progress_->cancel();
    }
    return child_->restrict_to(ball);
  }
  std::string name() const override { return "cancels"; }

  mutable std::atomic<int> repairs = 0;

 protected:
  void add_to(Digester& digester) const override { digester(child_); }

 private:
  field::NodePtr child_;
  double voxel_;
  Progress* progress_;
};

TEST(Polygonize, ACancelledRepairStopsAtThePolygon) {
  constexpr double kVoxel = 0.1;
  const field::Field ball = field::make("sphere", {{"radius", 0.8}});
  const field::Noise fbm = field::make_noise("fbm", {{"scale", 0.3}, {"octaves", 5}});
  const field::Field rock = field::make(
      "displace",
      {{"field", field::as_value(ball)}, {"noise", field::as_value(fbm)}, {"amount", 0.3}});
  volume::VoxelizeOptions voxels;
  voxels.voxel = kVoxel;
  const volume::LevelSet level_set = volume::voxelize(rock, voxels);
  const auto whole = std::make_shared<CancelsRepair>(rock.node(), kVoxel, nullptr);
  const field::Field uncancelled(whole);
  polygonize(level_set, &uncancelled);
  ASSERT_GT(whole->repairs, 20) << "the rock is too smooth for this test";
  Progress progress;
  const auto cancelling = std::make_shared<CancelsRepair>(rock.node(), kVoxel, &progress);
  const field::Field cancelled(cancelling);
  EXPECT_THROW(polygonize(level_set, &cancelled, {}, progress), Error);
  EXPECT_EQ(cancelling->repairs, 1);
}

}  // namespace
}  // namespace vug::meshing
