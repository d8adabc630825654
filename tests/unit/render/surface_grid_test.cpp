// SPDX-License-Identifier: Apache-2.0
// Ray tracing of a level set's surface without a mesh, against closed forms.
#include "surface_scenes.h"

#include <vug/base/error.h>
#include <vug/base/hash.h>
#include <vug/base/parallel.h>
#include <vug/field/affine.h>
#include <vug/paint/paint.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace vug::render {
namespace {

double angle(const Vec3f& a, const Vec3d& b) {
  return std::asin(std::min(1.0, Vec3d(a).normalized().cross(b.normalized()).length()));
}

/// The second derivatives of the distance to the origin sum to 2 / R along the axes; interpolation
/// errors are at most voxel^2 / 8 of that, and values are off by at most half a step.
double distance_bound(const volume::SurfaceBricks& surface) {
  return kVoxel * kVoxel / 8 * 2 / (1 - 2 * kVoxel) + surface.step();
}

TEST(SurfaceGrid, BallIsHitAtItsSurface) {
  const Object object = traced(ball());
  const PreparedScene world(only(object));
  const double bound = distance_bound(*object.surface);
  EXPECT_LT(bound, 0.015 * kVoxel);
  RandomStream random(RandomKey(1));
  size_t hits = 0;
  double off = 0, bend = 0, sharp = 0;
  for (int i = 0; i < 100000; ++i) {
    const Vec3f from = sample_sphere(pair(random)) * (i % 3 == 0 ? 0.5f : 4.0f);
    const Vec3f to = sample_sphere(pair(random)) * 1.2f * static_cast<float>(random.uniform());
    const Ray ray{from, normalized(to - from)};
    Hit hit;
    const bool found = world.intersect(ray, hit);
    ASSERT_EQ(world.occluded(ray, kFar), found);
    const Vec3d o(ray.origin), d(ray.direction);
    const double b = o.dot(d), nearest = std::sqrt(std::max(0.0, o.dot(o) - b * b));
    const bool inside = o.length() < 1;
    if (!inside && std::fabs(nearest - 1) < 2 * bound) continue;  // grazing
    ASSERT_EQ(found, inside || (nearest < 1 && b < 0)) << i;
    if (!found) continue;
    ++hits;
    const double root = std::sqrt(std::max(0.0, 1 - nearest * nearest));
    const double t = inside ? -b + root : -b - root;
    // For slanted rays, the error of the surface has a larger effect on the distance.
    ASSERT_NEAR(static_cast<double>(hit.distance), t, 2 * bound / std::max(root, 0.05));
    ASSERT_EQ(hit.surface.inside, inside);
    const Vec3d out = Vec3d(hit.surface.position) * (inside ? -1 : 1);
    off = std::max(off, std::fabs(out.length() - 1));
    bend = std::max(bend, angle(hit.surface.shading_normal, out));
    sharp = std::max(sharp, angle(hit.surface.geometric_normal, out));
  }
  EXPECT_GT(hits, 50000u);
  EXPECT_LT(off, bound);
  // Central differences, and interpolation between them, have errors of the order of the squared
  // voxel; the interpolant's own gradient of the order of the voxel. Normals at slanted surfaces
  // are turned towards the viewer: see Surface::face.
  EXPECT_LT(bend, 2 * kVoxel * kVoxel + 0.01);
  EXPECT_LT(sharp, 2 * kVoxel);
}

/// Points a tenth of a voxel apart have normals that differ accordingly, also across cells: no
/// facets. The interpolant's own gradient has facets, which shows that this test detects them.
TEST(SurfaceGrid, NormalsAreSmoothFromCellToCell) {
  const PreparedScene world(only(traced(ball())));
  constexpr double kApart = 0.1 * kVoxel;
  double smooth_jump = 0, sharp_jump = 0, error = 0;
  Hit last;
  for (int i = 0; i < 3000; ++i) {
    const double turn = kApart * i;
    const Vec3d at(std::cos(turn), 0.3 * std::sin(3.1 * turn), std::sin(turn));
    Hit hit;
    ASSERT_TRUE(world.intersect({Vec3f(at * 2.0), normalized(Vec3f(-at))}, hit));
    error = std::max(error, angle(hit.surface.shading_normal, Vec3d(hit.surface.position)));
    if (i > 0) {
      const double moved = Vec3d(hit.surface.position - last.surface.position).length();
      const auto jump = [&](const Vec3f& a, const Vec3f& b) {
        return Vec3d(a - b).length() - moved;
      };
      smooth_jump =
          std::max(smooth_jump, jump(hit.surface.shading_normal, last.surface.shading_normal));
      sharp_jump =
          std::max(sharp_jump, jump(hit.surface.geometric_normal, last.surface.geometric_normal));
    }
    last = hit;
  }
  EXPECT_LT(error, kVoxel * kVoxel);  // radians: 0.14 degrees
  EXPECT_LT(smooth_jump, 0.1 * kApart);
  EXPECT_GT(sharp_jump, 2 * kApart);
}

/// Random walks through air or rock whose steps start at hit origins. Counts how many leave a
/// closed world. `behind` counts hits right behind the surface that was passed.
struct Walk {
  size_t out = 0, behind = 0;
};
Walk walk(const PreparedScene& world, const Vec3f& from, bool in_rock, size_t steps) {
  Walk result;
  RandomStream random(RandomKey(2));
  const Ray start{from, {0, 0, 1}};
  Ray ray = start;
  for (size_t step = 0; step < steps; ++step) {
    Hit hit;
    if (!world.intersect(ray, hit) || hit.surface.inside != in_rock) {
      ++result.out;
      ray = start;
      continue;
    }
    result.behind += world.occluded({hit.behind, -hit.surface.geometric_normal},
                                    0.2f * static_cast<float>(kVoxel));
    ray.origin = hit.origin;
    const Frame frame(hit.surface.geometric_normal);
    ray.direction = frame.to_world(sample_cosine_hemisphere(pair(random)));
  }
  return result;
}

TEST(SurfaceGrid, SealedSolidsAreTightFromWithin) {
  for (const field::Field& solid : {ball(), rough()}) {
    const Walk done = walk(PreparedScene(only(traced(solid))), Vec3f(0.0f), true, 300000);
    EXPECT_EQ(done.out, 0u);
    EXPECT_LT(done.behind, 600u);  // nothing is close behind a surface, except in sharp valleys
  }
}

/// A cave behind walls of one and a half voxels: this would be a visible leak in a picture.
TEST(SurfaceGrid, SealedCavesAreTight) {
  const double wall = 1.5 * kVoxel;
  const PreparedScene smooth_cave(only(traced(field::subtract(ball(1 + wall), {ball()}))));
  EXPECT_EQ(walk(smooth_cave, Vec3f(0.0f), false, 500000).out, 0u);
  const PreparedScene rough_cave(only(traced(field::subtract(ball(1.6), {rough()}))));
  EXPECT_EQ(walk(rough_cave, Vec3f(0.0f), false, 500000).out, 0u);
}

/// Rays along the axes run along faces, edges and lattice points of cells; floors in a plane of
/// lattice points have the value 0 there.
TEST(SurfaceGrid, IsTightOnTheLattice) {
  const field::Field slab = field::make("box", {{"size", Vec3d(2, 1, 2)}});
  for (const field::Field& solid : {rough(), slab}) {
    const PreparedScene world(only(traced(solid)));
    const auto step = static_cast<float>(kVoxel);
    for (int i = -8; i <= 8; ++i)
      for (int j = -8; j <= 8; ++j)
        for (int axis = 0; axis < 3; ++axis)
          for (const float slant : {0.0f, 0.5f, 1.0f}) {
            Ray ray{Vec3f(0.0f), Vec3f(0.0f)};
            ray.direction[axis] = 1, ray.direction[(axis + 1) % 3] = slant;
            ray.direction = normalized(ray.direction);
            ray.origin[(axis + 1) % 3] = static_cast<float>(i) * step;
            ray.origin[(axis + 2) % 3] = static_cast<float>(j) * step;
            Hit hit;
            ASSERT_TRUE(world.intersect(ray, hit)) << i << " " << j << " " << axis;
            EXPECT_TRUE(hit.surface.inside);
            // And back in from outside.
            ray.origin = ray.origin + ray.direction * 5.0f, ray.direction = -ray.direction;
            ASSERT_TRUE(world.intersect(ray, hit)) << i << " " << j << " " << axis;
            EXPECT_FALSE(hit.surface.inside);
          }
  }
}

/// Where bricks meet, and everywhere else, a ray enters and leaves alternately.
TEST(SurfaceGrid, RaysEnterAndLeaveAlternately) {
  const PreparedScene world(only(traced(rough())));
  RandomStream random(RandomKey(5));
  for (int i = 0; i < 20000; ++i) {
    const Vec3f from = sample_sphere(pair(random)) * 5.0f;
    const Vec3f to = sample_sphere(pair(random)) * static_cast<float>(random.uniform());
    Ray ray{from, normalized(to - from)};
    bool inside = false;
    Hit hit;
    for (int face = 0; face < 50 && world.intersect(ray, hit); ++face) {
      ASSERT_EQ(hit.surface.inside, inside) << i;
      inside = !inside;
      ray.origin = hit.behind;
    }
    ASSERT_FALSE(inside) << i;
  }
}

/// Light that grazes a smooth ball is not occluded on the lit side: cells cast no shadows.
TEST(SurfaceGrid, CellsCastNoShadowsOnEachOther) {
  const PreparedScene world(only(traced(ball())));
  RandomStream random(RandomKey(9));
  size_t shadows = 0, asked = 0;
  for (int i = 0; i < 100000; ++i) {
    const Vec3f out = sample_sphere(pair(random));
    Hit hit;
    ASSERT_TRUE(world.intersect({out * 3.0f, -out}, hit));
    const Vec3f n = hit.surface.shading_normal;
    const Frame frame(n);
    const float turn = 6.2831853f * static_cast<float>(random.uniform());
    // Up to 6 degrees above the horizon; a polygonal mesh would have an error of half of that.
    const float rise = 0.002f + 0.1f * static_cast<float>(random.uniform());
    const Vec3f to = frame.to_world({std::cos(turn), std::sin(turn), rise});
    ++asked;
    shadows += world.occluded({hit.origin, normalized(to)}, kFar);
  }
  EXPECT_LT(static_cast<double>(shadows), 1e-3 * static_cast<double>(asked));
}

TEST(SurfaceGrid, HasTheSameBytesForAnyThreads) {
  const auto bricks = [](int threads) {
    return with_threads(threads, [&] {
      const volume::SurfaceBricks made(level_set(rough()));
      Hasher hash;
      hash.add(made.bricks().data(), made.bytes());
      return hash.finish();
    });
  };
  Scene scene = only(traced(rough()));
  scene.camera = view({0, 0.5, 4}, {0, 0, 0}, 0.6);
  scene.lights.push_back(make_light("sky", {{"radiance", Vec3d(1, 2, 3)}}));
  const auto picture = [&](int threads) {
    Options o = options(61, 37, 4, 4);
    o.threads = threads;
    return render(scene, o).pixels;
  };
  const Digest one = bricks(1);
  const std::vector<float> alone = picture(1);
  for (const int threads : {2, 5, 8}) {
    EXPECT_EQ(bricks(threads), one) << threads;
    EXPECT_EQ(picture(threads), alone) << threads;
  }
}

TEST(SurfaceGrid, RemovesSmallComponents) {
  const field::Field both =
      field::unite({ball(), field::transformed(ball(0.2), Transform::translation({3, 0, 0}))});
  const volume::SurfaceBricks all(level_set(both)), large(level_set(both), 1.0);
  EXPECT_EQ(all.components_removed(), 0u);
  EXPECT_EQ(large.components_removed(), 1u);
  EXPECT_GT(all.bounds().max.x, 3.1);
  EXPECT_LT(large.bounds().max.x, 1.1);
  const volume::SurfaceBricks alone(level_set(both), 100.0);
  EXPECT_EQ(alone.components_removed(), 1u);
  EXPECT_EQ(alone.bytes(), large.bytes());
}

TEST(SurfaceGrid, PaintIsEvaluatedAtTheHit) {
  Object object = traced(ball());
  object.color = paint::make_paint([](const paint::EvalPoint& spot) {
    return spot.position.y > 0 ? Vec3d(0.9, 2, -1) : spot.normal * -1.0;
  });
  const PreparedScene world(only(object));
  Hit hit;
  ASSERT_TRUE(world.intersect({{0, 3, 0}, {0, -1, 0}}, hit));
  EXPECT_EQ(hit.surface.color, Rgb(0.9f, 1, 0));
  ASSERT_TRUE(world.intersect({{0, -3, 0}, {0, 1, 0}}, hit));
  EXPECT_NEAR(hit.surface.color.y, 1, 1e-5);
}

TEST(SurfaceGrid, CannotBeEmissive) {
  Object object = traced(ball());
  object.emission = Rgb(1);
  EXPECT_THROW(PreparedScene(only(object)), Error);
}

/// A mesh needs about 550 bytes where the surface crosses a square of the size of a voxel.
TEST(SurfaceGrid, TakesLittleMemory) {
  const volume::SurfaceBricks bricks(level_set(ball()));
  const double area = 4 * kPi;
  EXPECT_LT(static_cast<double>(bricks.bytes()), 90 * area / (kVoxel * kVoxel));
  EXPECT_NEAR(static_cast<double>(bricks.bricks().size()), volume::brick_estimate(area, kVoxel),
              0.3 * volume::brick_estimate(area, kVoxel));
}

}  // namespace
}  // namespace vug::render
