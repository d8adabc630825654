// SPDX-License-Identifier: Apache-2.0
// Values near the surface, which the voxels of a level set use, agree with the plain evaluation of
// random networks voxel by voxel.
#include "passage_samples.h"

#include <vug/base/parallel.h>
#include <vug/field/near_surface.h>
#include <vug/field/translated.h>
#include <vug/volume/voxelize.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

using field::Field, field::LatticeBlock, field::NearSurface, field::Pack, field::Point;

/// Null for passages that are combined with other fields.
const NearSurface* near_surface(const Field& field) {
  return dynamic_cast<const NearSurface*>(field.node().get());
}

double lane(const Pack& pack, size_t i) {
  float lanes[Pack::kLanes];
  pack.store(lanes);
  return static_cast<double>(lanes[i]);
}

struct Counts {
  int near = 0, off = 0;
  int inside = 0;  // Blocks.
};

/// Compares a block with values and gradients of points. The gradient jumps where two segments have
/// the same value, so a few distances may differ.
void compare(const Field& field, const LatticeBlock& block, double limit, Counts& counts) {
  field::Scratch scratch;
  Pack values[LatticeBlock::kRuns], distances[LatticeBlock::kRuns];
  const field::BlockRange range =
      near_surface(field)->first_order(block, limit, {values, distances}, scratch);
  counts.inside += range == field::BlockRange::below;
  for (size_t run = 0; run < LatticeBlock::kRuns; ++run)
    for (size_t z = 0; z < 8; ++z) {
      const Vec3d p =
          block.origin + block.step * Vec3d(static_cast<double>(run / 8),
                                            static_cast<double>(run % 8), static_cast<double>(z));
      const field::Gradient g = field.gradient(p);
      if (range != field::BlockRange::near) {
        ASSERT_GT(range == field::BlockRange::above ? g.value : -g.value, limit - 2e-4) << p;
        continue;
      }
      if (std::fabs(g.value) > limit) {
        ASSERT_GT(std::fabs(lane(values[run], z)), limit - 2e-4) << p;
        ASSERT_GT(g.value * lane(values[run], z), 0) << p;
        continue;
      }
      const double value = lane(values[run], z), distance = lane(distances[run], z);
      ASSERT_NEAR(value, g.value, 1e-4) << p;
      ASSERT_GE(std::fabs(distance), std::fabs(value) * (1 - 1e-3)) << p;
      ++counts.near;
      counts.off += std::fabs(distance - g.value / g.gradient.length()) > 2e-3;
    }
}

TEST(NearSurface, BlocksEqualPoints) {
  size_t cases = 0;
  for (const PassageCase& c : passage_cases()) {
    if (!near_surface(c.field)) continue;
    ++cases;
    RandomStream random(RandomKey(31).at(c.label));
    Counts counts;
    for (int i = 0; i < 40; ++i) {
      LatticeBlock block;
      block.step = std::exp2(random.uniform(-4, 0));
      block.origin = point_near(c.field, random) - Vec3d(4 * block.step);
      const double limit = block.step * random.uniform(3, 5);
      SCOPED_TRACE(c.label);
      compare(c.field, block, limit, counts);
      if (HasFatalFailure()) return;
      const Field part = c.field.restricted_near(block.ball(), limit).field;
      compare(part, block, limit, counts);
      if (HasFatalFailure()) return;
    }
    EXPECT_GT(counts.near, 2000) << c.label;
    EXPECT_LT(counts.off, 0.02 * counts.near) << c.label;
  }
  EXPECT_GT(cases, passage_cases().size() / 2);
}

TEST(NearSurface, TranslatedPassagesKeepTheFastEvaluation) {
  for (const PassageCase& c : passage_cases()) {
    if (!near_surface(c.field)) continue;
    RandomStream random(RandomKey(34).at(c.label));
    Counts counts;
    for (int i = 0; i < 20; ++i) {
      LatticeBlock block;
      block.step = std::exp2(random.uniform(-4, 0));
      const Vec3d origin = point_near(c.field, random);
      block.origin = -Vec3d(4 * block.step);
      const double limit = 4 * block.step;
      const Field moved = field::translated(c.field, -origin);
      ASSERT_TRUE(near_surface(moved)) << c.label;
      SCOPED_TRACE(c.label);
      compare(moved, block, limit, counts);
      const Field part = moved.restricted_near(block.ball(), limit).field;
      ASSERT_TRUE(near_surface(part)) << c.label;
      if (!HasFatalFailure()) compare(part, block, limit, counts);
      if (HasFatalFailure()) return;
    }
    EXPECT_GT(counts.near, 1000) << c.label;
  }
}

TEST(NearSurface, BlocksInsideOfWidePassagesAreNotEvaluated) {
  const Field field =
      passages(with_radius(network_of({{0, 0, 0}, {30, 4, 0}, {40, 0, 25}}, {{0, 1}, {1, 2}}), 3));
  RandomStream random(RandomKey(33));
  Counts counts;
  for (int i = 0; i < 200; ++i) {
    LatticeBlock block;
    block.step = 0.1;
    block.origin = Vec3d(random.uniform(2, 28), random.uniform(-1, 5), random.uniform(-2, 2));
    compare(field, block, 0.3, counts);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(counts.inside, 20);
}

TEST(NearSurface, RestrictionKeepsValuesUpToTheLimit) {
  for (const PassageCase& c : passage_cases()) {
    RandomStream random(RandomKey(32).at(c.label));
    int near = 0;
    for (int i = 0; i < 60; ++i) {
      field::Ball ball{point_near(c.field, random), std::exp2(random.uniform(0, 6))};
      const double limit = random.uniform(0.1, 3);
      Field outer = c.field;
      for (int depth = 0; depth < 4; ++depth) {
        const Field::RestrictedField part = outer.restricted_near(ball, limit);
        for (int k = 0; k < 12; ++k) {
          const Vec3d p = ball.centre + random_vector(random, 0.57) * ball.radius;
          const double value = c.field.value(p), same = part.field.value(p);
          if (std::fabs(value) <= limit) {
            ++near;
            ASSERT_EQ(same, value) << c.label << " at " << p;
            ASSERT_TRUE(part.range.contains(value)) << c.label << " at " << p;
          } else {
            ASSERT_GT(std::fabs(same), limit) << c.label << " at " << p;
            ASSERT_GT(same * value, 0) << c.label << " at " << p;
            ASSERT_TRUE(part.range.lo <= value || value > limit) << c.label << " at " << p;
            ASSERT_TRUE(part.range.hi >= value || value < -limit) << c.label << " at " << p;
          }
        }
        ball.centre += random_vector(random, 0.28) * ball.radius;
        ball.radius *= 0.5;
        outer = part.field;
      }
    }
    EXPECT_GT(near, 100) << c.label;
  }
}

/// The same field without its own evaluation near the surface.
class Plain final : public field::Node {
 public:
  explicit Plain(field::NodePtr node) : Node(node->traits()), node_(std::move(node)) {}
  double eval(const Point<double>& p) const override { return node_->eval(p); }
  field::Dual<double> eval(const Point<field::Dual<double>>& p) const override {
    return node_->eval(p);
  }
  Interval eval(const Point<Interval>& p) const override { return node_->eval(p); }
  void eval(const Point<Pack>* points, int count, Pack* out,
            field::Scratch& scratch) const override {
    node_->eval(points, count, out, scratch);
  }
  void eval(const Point<Pack>* points, int count, field::Dual<Pack>* out,
            field::Scratch& scratch) const override {
    node_->eval(points, count, out, scratch);
  }
  field::Restriction restrict_to(const field::Ball& ball) const override {
    field::Restriction part = node_->restrict_to(ball);
    return {part.range, part.node ? std::make_shared<Plain>(part.node) : nullptr};
  }
  std::string name() const override { return "plain"; }

 protected:
  void add_to(vug::Digester& digester) const override { digester(node_); }

 private:
  field::NodePtr node_;
};

// The edge of the band is a comparison of rounded numbers, which may differ for single voxels.
TEST(NearSurface, LevelSetsEqualThoseOfThePlainEvaluation) {
  PassageOptions plain_tubes;  // Exact distances.
  plain_tubes.rules = {};
  plain_tubes.fillet = 0;
  const network::Network loop =
      with_radius(network_of({{0, 0, 0}, {20, 3, 0}, {18, 9, 20}}, {{0, 1}, {1, 2}, {2, 0}}), 1.5);
  std::vector<Field> fields = {passages(loop, plain_tubes)};
  EXPECT_EQ(fields[0].exactness(), field::Exactness::eikonal);
  for (const uint64_t seed : {1u, 2u, 3u}) fields.push_back(passages(random_cave(seed, 40)));
  for (size_t n = 0; n < fields.size(); ++n) {
    const Field& field = fields[n];
    volume::VoxelizeOptions options;
    options.voxel = 0.25;
    const volume::LevelSet fast = volume::voxelize(field, options),
                           plain = volume::voxelize(Field(std::make_shared<Plain>(field.node())),
                                                    options);
    const volume::Statistics one = fast.statistics(), other = plain.statistics();
    EXPECT_GT(other.active_voxels, 10000u) << n;
    EXPECT_NEAR(static_cast<double>(one.active_voxels), static_cast<double>(other.active_voxels),
                1e-5 * static_cast<double>(other.active_voxels));
    std::vector<Vec3d> points;
    for (int x = other.index_min.x; x <= other.index_max.x; ++x)
      for (int y = other.index_min.y; y <= other.index_max.y; ++y)
        for (int z = other.index_min.z + x % 3; z <= other.index_max.z; z += 3)
          points.push_back(options.voxel * Vec3d(x, y, z));
    const std::vector<double> mine = fast.values(points), expected = plain.values(points);
    size_t off = 0;
    for (size_t i = 0; i < points.size(); ++i) off += std::fabs(mine[i] - expected[i]) > 1e-4;
    EXPECT_LE(off, points.size() / 100000) << "field " << n;
  }
}

TEST(NearSurface, LevelSetsDoNotDependOnThreads) {
  const Field field = passages(random_cave(5, 30));
  volume::VoxelizeOptions options;
  options.voxel = 0.3;
  const auto content = [&](int threads) {
    return with_threads(threads, [&] { return volume::voxelize(field, options).content(); });
  };
  const Digest expected = content(1);
  for (const int threads : {2, 7}) EXPECT_EQ(content(threads), expected) << threads;
}

}  // namespace
}  // namespace vug::passages
