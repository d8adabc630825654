// SPDX-License-Identifier: Apache-2.0
// The evaluation modes of a formula agree: batch and scalar, value and gradient, gradient and
// differences; and none of them ever yields NaN.
#include "sweep.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vug::field {
namespace {

/// The slope along each axis, if left and right differences agree (away from creases).
std::optional<Vec3d> differences(const Field& f, const Vec3d& p) {
  const double h = 1e-5;
  Vec3d slope;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3d step(0);
    step[axis] = h;
    const double here = f.value(p), right = f.value(p + step), left = f.value(p - step);
    if (std::fabs(right - 2 * here + left) > 2e-3 * h) return std::nullopt;
    slope[axis] = (right - left) / (2 * h);
  }
  return slope;
}

TEST(Sweep, GradientsEqualDifferences) {
  for_each_case([&](const SweepCase& c) {
    RandomStream random(RandomKey(21).at(c.label));
    int smooth = 0;
    for (int i = 0; i < 500; ++i) {
      const Vec3d p = random_point(random, 2);
      const auto slope = differences(c.field, p);
      if (!slope) continue;
      ++smooth;
      const Gradient g = c.field.gradient(p);
      ASSERT_NEAR(g.value, c.field.value(p), 1e-12 * (1 + std::fabs(g.value))) << c.label;
      ASSERT_LT((g.gradient - *slope).length(), 2e-3 * std::max(1.0, c.field.lipschitz()))
          << c.label << " at " << p << ": " << g.gradient << " against " << *slope;
    }
    // Noise with many octaves bends too much for finite differences; the few smooth points are
    // tested.
    if (c.field.lipschitz() <= 2) {
      EXPECT_GT(smooth, 250) << c.label;
    }
  });
}

struct Batch {
  static constexpr int kPacks = 4;
  static constexpr int kPoints = kPacks * Pack::kLanes;
  Point<Pack> points[kPacks];
  Vec3d where[kPoints];  // The points after rounding to single precision.

  template <class Draw>
  explicit Batch(const Draw& draw) {
    for (int k = 0; k < kPacks; ++k) {
      float xyz[3][Pack::kLanes];
      for (int lane = 0; lane < Pack::kLanes; ++lane) {
        const Vec3d p = draw();
        for (int axis = 0; axis < 3; ++axis) {
          xyz[axis][lane] = static_cast<float>(p[axis]);
          where[k * Pack::kLanes + lane][axis] = static_cast<double>(xyz[axis][lane]);
        }
      }
      points[k] = {Pack::load(xyz[0]), Pack::load(xyz[1]), Pack::load(xyz[2])};
    }
  }
  std::vector<Gradient> gradients(const Field& field, Scratch& scratch) const {
    Dual<Pack> out[kPacks];
    field.gradients(points, kPacks, out, scratch);
    std::vector<Gradient> all(kPoints);
    for (int k = 0; k < kPacks; ++k) {
      float part[4][Pack::kLanes];
      out[k].v.store(part[0]);
      out[k].dx.store(part[1]);
      out[k].dy.store(part[2]);
      out[k].dz.store(part[3]);
      for (int lane = 0; lane < Pack::kLanes; ++lane)
        all[static_cast<size_t>(k * Pack::kLanes + lane)] = {
            part[0][lane], Vec3d(Vec3f(part[1][lane], part[2][lane], part[3][lane]))};
    }
    return all;
  }
  std::vector<float> values(const Field& field, Scratch& scratch) const {
    Pack out[kPacks];
    field.values(points, kPacks, out, scratch);
    std::vector<float> all(kPoints);
    for (int k = 0; k < kPacks; ++k) out[k].store(all.data() + k * Pack::kLanes);
    return all;
  }
};

TEST(Sweep, BatchesAgreeWithScalars) {
  Scratch scratch;
  for_each_case([&](const SweepCase& c) {
    RandomStream random(RandomKey(22).at(c.label));
    // Single precision stores coordinates to 1.2e-7 of 4 m, and a formula takes a few tens of
    // steps.
    const double tolerance = 1e-5 * std::max(1.0, c.field.lipschitz());
    int compared = 0;
    for (int round = 0; round < 16; ++round) {
      const Batch batch([&] { return random_point(random, 2); });
      const std::vector<float> values = batch.values(c.field, scratch);
      const std::vector<Gradient> gradients = batch.gradients(c.field, scratch);
      for (size_t i = 0; i < values.size(); ++i) {
        const Vec3d& p = batch.where[i];
        const double value = c.field.value(p), allowed = tolerance * (1 + 0.1 * std::fabs(value));
        ASSERT_NEAR(static_cast<double>(values[i]), value, allowed) << c.label << " at " << p;
        ASSERT_NEAR(gradients[i].value, value, allowed) << c.label << " at " << p;
        if (!differences(c.field, p)) continue;  // At a crease the two may take either side.
        ++compared;
        ASSERT_LT((gradients[i].gradient - c.field.gradient(p).gradient).length(),
                  3e-3 * std::max(1.0, c.field.lipschitz()))
            << c.label << " at " << p;
      }
    }
    if (c.field.lipschitz() <= 2) {
      EXPECT_GT(compared, 250) << c.label;
    }
  });
}

TEST(Sweep, NothingIsEverNaN) {
  const double nasty[] = {0.0, -0.0, 5e-324, -1e-310, 1e-40, 1e-20, 0.5, -0.5, 1, -1, 1e6, -1e6};
  constexpr uint32_t kCount = sizeof nasty / sizeof nasty[0];
  Scratch scratch;
  for_each_case([&](const SweepCase& c) {
    RandomStream random(RandomKey(23).at(c.label));
    const auto check = [&](const Gradient& g, const Vec3d& p) {
      ASSERT_TRUE(std::isfinite(g.value)) << c.label << " at " << p;
      ASSERT_TRUE(std::isfinite(g.gradient.length())) << c.label << " at " << p << g.gradient;
    };
    const auto draw = [&] {
      return Vec3d(nasty[random.below(kCount)], nasty[random.below(kCount)],
                   nasty[random.below(kCount)]);
    };
    for (int round = 0; round < 60; ++round) {
      const Batch batch(draw);
      for (const Vec3d& p : batch.where) {
        check(c.field.gradient(p), p);
        const Interval at = c.field.interval({p, p});
        ASSERT_FALSE(std::isnan(at.lo) || std::isnan(at.hi)) << c.label << " at " << p;
      }
      const std::vector<Gradient> gradients = batch.gradients(c.field, scratch);
      const std::vector<float> values = batch.values(c.field, scratch);
      for (size_t i = 0; i < values.size(); ++i) {
        check(gradients[i], batch.where[i]);
        ASSERT_TRUE(std::isfinite(values[i])) << c.label << " at " << batch.where[i];
      }
    }
  });
}

}  // namespace
}  // namespace vug::field
