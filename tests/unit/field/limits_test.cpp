// SPDX-License-Identifier: Apache-2.0
// Speleothems with lumps evaluate their noise only where their value can be below a limit, with the
// same bits there; and placed nodes have the same maps however they were moved.
#include <vug/base/rng.h>
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/displace.h>
#include <vug/field/evaluates_below.h>
#include <vug/field/lathe.h>
#include <vug/field/material_source.h>
#include <vug/field/numbers/value_of.h>
#include <vug/field/placement.h>
#include <vug/field/registry.h>
#include <vug/field/speleothems/turned.h>
#include <vug/field/translated.h>

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <optional>
#include <vector>

namespace vug::field {
namespace {

constexpr int kPacks = 16;
constexpr size_t kNumbers = kPacks * Pack::kLanes;

/// A noise that counts the packs at which it is evaluated.
class CountingNoise final : public EvaluationModes<CountingNoise> {
 public:
  explicit CountingNoise(NodePtr noise) : EvaluationModes(noise->traits()), noise_(noise) {}
  template <class T>
  T at(const Point<T>& p) const {
    return noise_->eval(p);
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    packs += count;
    noise_->eval(points, count, out, scratch);
  }
  std::string name() const override { return "counting"; }
  mutable int packs = 0;

 protected:
  void add_to(Digester& digester) const override { digester(noise_); }

 private:
  NodePtr noise_;
};

Field turned() { return lathe("stalagmite", {{0, 0}, {0.5, 0}, {0.3, 1}, {0.2, 2}, {0, 2.1}}); }
Noise lump_noise() { return make_noise("fbm", {{"scale", 0.4}, {"octaves", 3.0}}); }
Displacement by_amount(double amount) {
  Displacement out;
  out.amount = amount;
  return out;
}
Field lumpy(const Displacement& options = by_amount(0.15)) {
  return displaced(turned(), lump_noise(), options);
}
Field bent_lumps() { return bent(lumpy(), {BendProfile::foot, Vec3d(0.3, 0, 0.1), 0, 2}); }
Transform tilted() {
  return Transform::translation({0.2, -1, 0.1}) * Transform::rotation({1, 0, 2}, 0.4);
}

std::vector<std::pair<std::string, Field>> limited_fields() {
  Displacement by_slope = by_amount(0.1);
  by_slope.floor = 1.5, by_slope.wall = -0.5, by_slope.ceiling = 0.2;
  Displacement masked = by_amount(0.1);
  masked.by = make_noise("fbm", {{"scale", 1.0}, {"seed", 5.0}});
  const Transform flat = Transform::scaling({2, 0.5, 1}) * tilted();
  return {{"lumpy", lumpy()},
          {"by slope", lumpy(by_slope)},
          {"masked", lumpy(masked)},
          {"twice", displaced(lumpy(), lump_noise(), by_amount(0.05))},
          {"moved", transformed(lumpy(), Transform::translation({0.3, -1, 0.2}))},
          {"tilted", transformed(bent_lumps(), tilted())},
          {"flattened", transformed(lumpy(), flat)},
          {"smaller", transformed(lumpy(), Transform::scaling({0.5, 0.5, 0.5}))},
          {"bent", translated(bent_lumps(), {0.2, -0.5, 0})}};
}

template <class T>
bool equal_lane(const T& a, const T& b, size_t lane) {
  std::array<float, sizeof(T) / sizeof(float)> x, y;
  std::memcpy(x.data(), &a, sizeof a);
  std::memcpy(y.data(), &b, sizeof b);
  for (size_t i = lane; i < x.size(); i += Pack::kLanes)
    if (std::memcmp(&x[i], &y[i], sizeof(float)) != 0) return false;
  return true;
}
float lane_of(const Pack& p, size_t lane) {
  float lanes[Pack::kLanes];
  p.store(lanes);
  return lanes[lane];
}

struct LimitBatch {
  Point<Pack> points[kPacks];
  Pack limits[kPacks];

  explicit LimitBatch(RandomStream& random) {
    const double level = random.uniform(-0.3, 1);
    float numbers[4][kNumbers];
    for (size_t i = 0; i < kNumbers; ++i) {
      for (int axis = 0; axis < 3; ++axis)
        numbers[axis][i] = static_cast<float>(random.uniform(-1.5, 1.5));
      numbers[3][i] = static_cast<float>(level + random.uniform(-0.2, 0.2));
    }
    for (size_t k = 0; k < kPacks; ++k) {
      const size_t at = k * Pack::kLanes;
      points[k] = {Pack::load(numbers[0] + at), Pack::load(numbers[1] + at),
                   Pack::load(numbers[2] + at)};
      limits[k] = Pack::load(numbers[3] + at);
    }
  }
};

template <class T>
void expect_equal_below(const std::string& name, const Node& node, const LimitBatch& batch,
                        std::array<int, 2>& sides) {
  Scratch scratch;
  T all[kPacks], some[kPacks];
  node.eval(batch.points, kPacks, all, scratch);
  evaluate_below(node, batch.points, batch.limits, kPacks, some, scratch);
  for (size_t k = 0; k < kPacks; ++k)
    for (size_t lane = 0; lane < Pack::kLanes; ++lane) {
      const float limit = lane_of(batch.limits[k], lane);
      const bool below = lane_of(value_of(all[k]), lane) < limit;
      ++sides[below ? 1 : 0];
      if (below)
        ASSERT_TRUE(equal_lane(all[k], some[k], lane)) << name;
      else
        ASSERT_GE(lane_of(value_of(some[k]), lane), limit) << name;
    }
}

TEST(Limits, ValuesBelowThemHaveTheSameBits) {
  for (const auto& [name, field] : limited_fields()) {
    ASSERT_TRUE(evaluates_below(*field.node())) << name;
    RandomStream random(RandomKey(31).at(name));
    std::array<int, 2> sides{};
    for (int round = 0; round < 100; ++round) {
      const LimitBatch batch(random);
      expect_equal_below<Pack>(name, *field.node(), batch, sides);
      expect_equal_below<Dual<Pack>>(name, *field.node(), batch, sides);
    }
    EXPECT_GT(sides[0], 1000) << name;
    EXPECT_GT(sides[1], 1000) << name;
  }
}

TEST(Limits, NoisesAreNotEvaluatedAboveThem) {
  const auto counting = std::make_shared<CountingNoise>(lump_noise().field.node());
  const Field form = transformed(
      bent(displaced(turned(), Noise(Field(counting), lump_noise().range), by_amount(0.15)),
           {BendProfile::foot, Vec3d(0.3, 0, 0.1), 0, 2}),
      tilted());
  RandomStream random(RandomKey(32));
  LimitBatch batch(random);
  Scratch scratch;
  Pack out[kPacks];
  for (Pack& limit : batch.limits) limit = Pack(-1.0);  // The solid has no value below it.
  evaluate_below(*form.node(), batch.points, batch.limits, kPacks, out, scratch);
  EXPECT_EQ(counting->packs, 0);
  batch.limits[3] = Pack(5.0);
  evaluate_below(*form.node(), batch.points, batch.limits, kPacks, out, scratch);
  EXPECT_EQ(counting->packs, 1);
}

TEST(Limits, OnlyNodesThatSaveWorkAreAskedForLimits) {
  const Field orb = make("sphere", {{"radius", 1.0}});
  EXPECT_FALSE(evaluates_below(*orb.node()));
  EXPECT_FALSE(evaluates_below(*transformed(orb, tilted()).node()));
  EXPECT_FALSE(evaluates_below(*turned().node()));
  EXPECT_TRUE(evaluates_below(*lumpy().node()));
  EXPECT_TRUE(evaluates_below(*transformed(unite({orb, turned()}), tilted()).node()));
}

TEST(Interfaces, AreThoseOfDynamicCasts) {
  std::vector<Field> fields = {make("box"), make("sphere"), turned(), unite({turned(), lumpy()})};
  for (const auto& [name, field] : limited_fields()) fields.push_back(field);
  for (int round = 0; round < 2; ++round)
    for (const Field& field : fields) {
      const Node& node = *field.node();
      EXPECT_EQ(interface_of<EvaluatesBelow>(node), dynamic_cast<const EvaluatesBelow*>(&node));
      EXPECT_EQ(interface_of<MaterialSource>(node), dynamic_cast<const MaterialSource*>(&node));
      EXPECT_EQ(interface_of<Node>(node), &node);
    }
}

/// Restricted unions share operands with the whole.
TEST(Limits, RestrictedUnionsOutliveTheWhole) {
  RandomStream random(RandomKey(34));
  std::vector<Field> solids;
  for (int i = 0; i < 60; ++i) {
    const double x = random.uniform(-4, 4), y = random.uniform(-4, 4);
    const Vec3d at(x, y, random.uniform(-4, 4));
    solids.push_back(transformed(i % 2 ? lumpy() : turned(), Transform::translation(at)));
  }
  std::optional<Field> whole = unite(std::move(solids));
  const Vec3d p(0.3, 0.2, -0.4);
  const double expected = whole->value(p);
  std::optional<Field> part = translated(*whole, Vec3d(1, 0, 0)).restricted({{1, 0, 0}, 3}).field;
  whole.reset();
  const Field smaller = part->restricted({{1, 0, 0}, 1}).field;
  EXPECT_LT(node_count(smaller), node_count(*part));
  part.reset();
  EXPECT_NEAR(smaller.value(p + Vec3d(1, 0, 0)), expected, 1e-9);
}

void expect_equal(const Transform& a, const Transform& b) {
  EXPECT_EQ(a.origin(), b.origin());
  for (int i = 0; i < 3; ++i) EXPECT_EQ(a.column(i), b.column(i));
}

TEST(Placement, IsThatOfTheMovedMap) {
  RandomStream random(RandomKey(33));
  for (int round = 0; round < 50; ++round) {
    const auto draw = [&] {
      const double x = random.uniform(-9, 9), y = random.uniform(-9, 9);
      return Vec3d(x, y, random.uniform(-9, 9));
    };
    const Transform turn = Transform::rotation(draw(), random.uniform(0, 3));
    const Transform stretch = Transform::scaling({1, random.uniform(0.5, 2), 1});
    for (const Transform& map : {turn, turn * stretch, Transform()}) {
      const Transform placed = Transform::translation(draw()) * map;
      const Vec3d by = draw();
      const Field moved = translated(transformed(bent_lumps(), placed), by),
                  made = transformed(bent_lumps(), Transform::translation(by) * placed);
      const auto at = placement_of(*moved.node()), inverse = inverse_placement_of(*moved.node());
      ASSERT_TRUE(at && inverse);
      expect_equal(*inverse, at->inverse());
      expect_equal(at->inverse(), placement_of(*made.node())->inverse());
      EXPECT_EQ(moved.digest(), made.digest());
      EXPECT_EQ(moved.bounds(), made.bounds());
      EXPECT_EQ(moved.lipschitz(), made.lipschitz());
      EXPECT_EQ(moved.node()->traits().growth, made.node()->traits().growth);
    }
  }
  EXPECT_FALSE(inverse_placement_of(*turned().node()));
}

}  // namespace
}  // namespace vug::field
