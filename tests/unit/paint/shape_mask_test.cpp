// SPDX-License-Identifier: Apache-2.0
// The masks of edges and cavities use true distances, whatever the field's values.
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/registry.h>
#include <vug/paint/kind.h>
#include <vug/paint/solid_fraction.h>
#include <vug/volume/level_set_field.h>
#include <vug/volume/voxelize.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::paint {
namespace {

constexpr double kRadius = 0.12;

field::Field block(const Vec3d& size, const Vec3d& centre) {
  return field::transformed(field::make("box", {{"size", size}}), Transform::translation(centre));
}

/// A step, seen along z: 2 m wide, 1 m high on the left and 2 m on the right, with its inner corner
/// at (0, 0.5). It is built in a space 8 times narrower and 4 times deeper, so that its field is
/// far from a distance, and its faces are roughened.
field::Field step() {
  const Vec3d squeeze(8, 1, 0.25);
  const field::Field low = block(Vec3d(2, 1, 1) / squeeze, Vec3d(0, 0, 0));
  const field::Field high = block(Vec3d(1, 1, 1) / squeeze, Vec3d(0.5, 1, 0) / squeeze);
  const field::Field solid =
      field::transformed(field::unite({low, high}), Transform::scaling(squeeze));
  return field::make("displace",
                     {{"field", ValueTraits<field::Field>::write(solid)}, {"amount", 0.0002}});
}

struct Probe {
  field::Field field = step();
  std::shared_ptr<const field::SampledGrid> grid;

  Probe() {
    volume::VoxelizeOptions options;
    options.voxel = 0.02;
    grid = volume::sampled_grid(volume::voxelize(field, options));
  }
  /// The point where the surface crosses the line through p along `out`.
  EvalPoint at(const Vec3d& p, const Vec3d& out) const {
    const Vec3d n = out.normalized();
    double low = -0.05, high = 0.05;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (low + high);
      (field.value(p + n * middle) < 0 ? low : high) = middle;
    }
    return {p + n * low, n, grid.get()};
  }
};

Mask shape_mask(const std::string& name) {
  Diagnostics diagnostics;
  const Arguments arguments = {{"radius", Number{kRadius, Dimension::length}, {}}};
  return *find_kind(masks(), name)->make(arguments, {}, diagnostics);
}

TEST(ShapeMasks, DistinguishEdgesFromHollowsOnAScaledRoughStep) {
  const Probe probe;
  const Mask edge = shape_mask("edge"), cavity = shape_mask("cavity");
  // The relief (0.2 mm in values, up to 6 mm in space) bends faces by hundredths; voxels of a sixth
  // of the radius round off edges.
  const double near = 0.15;
  for (const EvalPoint& flat :
       {probe.at({-0.5, 0.5, 0}, {0, 1, 0}), probe.at({-1, 0, 0.1}, {-1, 0, 0}),
        probe.at({0.5, 0.7, 0.5}, {0, 0, 1}), probe.at({0, 1, 0}, {-1, 0, 0})}) {
    EXPECT_NEAR((*edge)(flat), 0, near) << flat.position;
    EXPECT_NEAR((*cavity)(flat), 0, near) << flat.position;
  }
  for (const EvalPoint& side :
       {probe.at({-1, 0.5, 0}, {-1, 1, 0}), probe.at({1, 1.5, 0}, {1, 1, 0}),
        probe.at({-0.5, 0.5, 0.5}, {0, 1, 1})}) {
    EXPECT_NEAR((*edge)(side), 1, near) << side.position;
    EXPECT_EQ((*cavity)(side), 0) << side.position;
  }
  EXPECT_EQ((*edge)(probe.at({-1, 0.5, 0.5}, {-1, 1, 1})), 1);
  const EvalPoint inner = probe.at({0, 0.5, 0}, {-1, 1, 0});
  EXPECT_NEAR((*cavity)(inner), 1, near);
  EXPECT_EQ((*edge)(inner), 0);
}

TEST(ShapeMasks, FadeOverTheirRadius) {
  const Probe probe;
  const Mask edge = shape_mask("edge");
  double last = 2;
  for (const double away : {0.15, 0.35, 0.6, 1.3}) {
    const double value = (*edge)(probe.at({-1 + away * kRadius, 0.5, 0}, {0, 1, 0}));
    EXPECT_LE(value, last);
    last = value;
  }
  EXPECT_LT(last, 0.15);
}

TEST(ShapeMasks, SphereHasTheFractionOfTwoBalls) {
  volume::VoxelizeOptions options;
  options.voxel = 0.02;
  const auto grid =
      volume::sampled_grid(volume::voxelize(field::make("sphere", {{"radius", 1.0}}), options));
  // The intersection of a unit ball and a ball of radius r centred on its surface, as a fraction of
  // the latter: 1/2 - 3 r / 16.
  for (const double radius : {0.2, 0.4}) {
    const EvalPoint point{{0.6, 0.8, 0}, {0.6, 0.8, 0}, grid.get()};
    EXPECT_NEAR(solid_fraction(point, radius), 0.5 - 3 * radius / 16, 0.01);
  }
  EXPECT_EQ(solid_fraction({{0, 0, 0}, {0, 1, 0}, nullptr}, 1), 0.5);
}

}  // namespace
}  // namespace vug::paint
