// SPDX-License-Identifier: Apache-2.0
#include "solids.h"

#include <vug/base/parallel.h>
#include <vug/field/noise.h>
#include <vug/mesh/distance.h>
#include <vug/meshing/exact_distances.h>
#include <vug/volume/band.h>
#include <vug/volume/redistance.h>

#include <gtest/gtest.h>

#include <functional>
#include <mutex>

namespace vug::meshing {
namespace {

using Truth = std::function<double(const Vec3d&)>;

volume::LevelSet level_set_of(const field::Field& solid, double voxel) {
  volume::VoxelizeOptions options;
  options.voxel = voxel;
  return volume::voxelize(solid, options);
}

/// The largest error in the band, in voxels. Inactive voxels count if they belong to the band.
double largest_error(const volume::LevelSet& level_set, const Truth& truth) {
  std::mutex lock;
  double largest = 0;
  const auto compare = [&](const volume::BandBlock& block, std::vector<double>& found) {
    const std::vector<double> values = level_set.values(block.points);
    double here = 0;
    for (size_t i = 0; i < values.size(); ++i) {
      const double exact =
          std::clamp(truth(block.points[i]), -level_set.background(), level_set.background());
      here = std::max(here, std::fabs(values[i] - exact) / level_set.voxel());
      found[i] = std::fabs(values[i]);
    }
    const std::lock_guard guard(lock);
    largest = std::max(largest, here);
  };
  (void)volume::with_distances(level_set, compare, Progress::none());
  return largest;
}

/// A cube from -1 to 1 from which a ball around the middle of its upper face is cut.
struct DentedBox {
  static constexpr double kRadius = 0.6;
  static field::Field solid() {
    return field::subtract(field::make("box", {{"size", Vec3d(2)}}),
                           {field::transformed(field::make("sphere", {{"radius", kRadius}}),
                                               Transform::translation({0, 1, 0}))});
  }
  static double distance(const Vec3d& p) {
    const Vec3d q(std::fabs(p.x), p.y, std::fabs(p.z));
    const double ring = std::hypot(p.x, p.z);
    const double to_edge = std::hypot(ring - kRadius, p.y - 1);
    const Vec3d from_centre = p - Vec3d(0, 1, 0);
    const double to_bowl = p.y <= 1 ? std::fabs(from_centre.length() - kRadius) : to_edge;
    const Vec3d over(std::max(q.x - 1, 0.0), std::max(std::fabs(q.y) - 1, 0.0),
                     std::max(q.z - 1, 0.0));
    const bool in_box = over == Vec3d(0);
    double to_faces = over.length();
    if (in_box) {
      to_faces = std::min({1 - q.x, 1 - q.z, 1 + p.y});
      to_faces = std::min(to_faces, ring >= kRadius ? 1 - p.y : to_edge);
    } else if (p.y > 1 && ring < kRadius) {
      to_faces = to_edge;
    }
    const bool inside = in_box && from_centre.length() > kRadius;
    return (inside ? -1 : 1) * std::min(to_faces, to_bowl);
  }
};

struct Comparison {
  const char* name;
  field::Field solid;
  Truth truth;
};

/// A wedge as the intersection of half-spaces in a box; the primitive has exact distances.
Comparison wedge(const char* name, double height) {
  const Vec3d size(2, height, 1.5);
  const auto half_space = [](const Vec3d& normal, double offset) {
    return field::make("half_space", {{"normal", normal}, {"offset", offset}});
  };
  const field::Field solid = field::intersect(
      {half_space({-1, 0, 0}, size.x / 2), half_space({0, -1, 0}, size.y / 2),
       half_space({size.y, size.x, 0}, 0), half_space({0, 0, 1}, size.z / 2),
       half_space({0, 0, -1}, size.z / 2), field::make("box", {{"size", size + Vec3d(1)}})});
  const field::Field exact = field::make("wedge", {{"size", size}});
  return {name, solid, [exact](const Vec3d& p) { return exact.value(p); }};
}

/// Other solids are compared with a much finer mesh.
Comparison against_fine_mesh(const char* name, const field::Field& solid, double voxel) {
  const mesh::MeshDistance fine(polygonized(solid, voxel).mesh);
  return {name, solid,
          [=](const Vec3d& p) { return std::copysign(fine.closest(p).distance, solid.value(p)); }};
}

field::Field rough_ball() {
  const field::Noise fbm = field::make_noise("fbm", {{"scale", 0.8}, {"octaves", 3}});
  return field::make("displace",
                     {{"field", field::as_value(field::make("sphere", {{"radius", 1.0}}))},
                      {"noise", field::as_value(fbm)},
                      {"amount", 0.12}});
}

field::Field blended() {
  return field::unite({field::make("box", {{"size", Vec3d(1.6)}}),
                       field::transformed(field::make("sphere", {{"radius", 0.7}}),
                                          Transform::translation({0.7, 0.8, 0.4}))},
                      field::Blend{field::Profile::smooth, 0.3});
}

Comparison placed(const Comparison& given, const Transform& at) {
  const Transform back = at.inverse();
  return {given.name, field::transformed(given.solid, at),
          [=](const Vec3d& p) { return given.truth(back.point(p)); }};
}

std::vector<Transform> placements() {
  return {Transform(), Transform::translation(Vec3d(0.0131, -0.0227, 0.0179)),
          Transform::translation(Vec3d(0.02, 0.01, 0.03)) * Transform::rotation({1, 2, 3}, 0.7),
          Transform::rotation({2, -1, 1}, 0.35), Transform::rotation({0, 0, 1}, 0.5)};
}

TEST(ExactDistances, AreExactOutsideSharpEdges) {
  for (const Comparison& given :
       {Comparison{"box minus ball", DentedBox::solid(), DentedBox::distance},
        wedge("wedge of 45 degrees", 2), wedge("wedge of 31 degrees", 1.2),
        wedge("wedge of 17 degrees", 0.6)})
    for (const Transform& at : placements()) {
      SCOPED_TRACE(given.name);
      const Comparison here = placed(given, at);
      const volume::LevelSet bounds = level_set_of(here.solid, 0.07);
      const volume::LevelSet exact = exact_distances(bounds, here.solid);
      EXPECT_GT(largest_error(bounds, here.truth), 0.8);
      EXPECT_LT(largest_error(exact, here.truth), 0.005);
      EXPECT_EQ(volume::check(exact).fault, "");
    }
}

TEST(ExactDistances, OfRoughAndBlendedSolidsAgreeWithAFinerMesh) {
  for (const Comparison& given : {against_fine_mesh("rough ball", rough_ball(), 0.02),
                                  against_fine_mesh("blend", blended(), 0.02)}) {
    SCOPED_TRACE(given.name);
    const volume::LevelSet bounds = level_set_of(given.solid, 0.08);
    const volume::LevelSet exact = exact_distances(bounds, given.solid);
    EXPECT_GT(largest_error(bounds, given.truth), 0.1);
    EXPECT_LT(largest_error(exact, given.truth), 0.1);
  }
}

TEST(ExactDistances, TheSameBytesForAnyNumberOfThreads) {
  const field::Field solid = cut_box();
  const volume::LevelSet bounds = level_set_of(solid, 0.08);
  const Digest reference = exact_distances(bounds, solid).content();
  for (const int threads : {1, 2, 5, 8})
    with_threads(threads, [&] { EXPECT_EQ(exact_distances(bounds, solid).content(), reference); });
}

}  // namespace
}  // namespace vug::meshing
