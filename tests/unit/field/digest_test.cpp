// SPDX-License-Identifier: Apache-2.0
// Digests identify fields: equal digests imply equal values, whatever way the nodes were made.
#include "sweep.h"

#include <vug/base/parallel.h>
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/field/noise.h>

#include <gtest/gtest.h>

#include <atomic>
#include <set>

namespace vug::field {
namespace {

Field field_of(const Field& made) { return made; }
Field field_of(const Noise& made) { return made.field; }

template <class Product>
std::optional<Field> make_with(const Kind<Product>& kind, const Arguments& arguments) {
  Diagnostics diagnostics;
  const std::optional<Product> made = kind.make(arguments, {}, diagnostics);
  return made ? std::optional(field_of(*made)) : std::nullopt;
}

bool same_values(const Field& a, const Field& b) {
  RandomStream random(RandomKey(3).at("points"));
  for (int i = 0; i < 200; ++i) {
    const Vec3d p = random_point(random, i % 2 ? 2.0 : 0.7);
    if (a.value(p) != b.value(p)) return false;
  }
  return true;
}

/// Draws arguments twice, which makes all values anew, and then others for each parameter.
template <class Product>
void check(const Kind<Product>& kind) {
  const KindInfo& info = kind.info;
  int checked = 0;
  std::set<std::string> counted;
  for (uint64_t round = 0; round < 60 && checked < 6; ++round) {
    const RandomKey key = RandomKey(11).at(info.name).at(round);
    const auto draw = [&] {
      RandomStream random(key);
      return draw_arguments(info, random);
    };
    const Arguments arguments = draw();
    const std::optional<Field> first = make_with(kind, arguments);
    const std::optional<Field> again = make_with(kind, draw());
    ASSERT_EQ(first.has_value(), again.has_value());
    if (!first) continue;  // The parameters contradict each other.
    ++checked;
    EXPECT_EQ(first->digest(), again->digest()) << info.name;
    for (size_t i = 0; i < arguments.size(); ++i)
      for (uint64_t attempt = 0; attempt < 3; ++attempt) {
        Arguments other = arguments;
        const auto param =
            std::find_if(info.params.begin(), info.params.end(),
                         [&](const ParamInfo& each) { return each.name == arguments[i].name; });
        RandomStream random(key.at("other").at(i).at(attempt));
        other[i].value = draw_value(*param, info.name, random);
        const std::optional<Field> changed = make_with(kind, other);
        if (!changed) continue;
        if (changed->digest() != first->digest())
          counted.insert(param->name);
        else
          EXPECT_TRUE(same_values(*first, *changed))
              << info.name << ": another '" << param->name << "' changes values but not the digest";
      }
  }
  EXPECT_GT(checked, 0) << info.name;
  // The fixture of `grid` is the same for all files.
  EXPECT_EQ(counted.empty(), info.params.empty() || info.name == "grid") << info.name;
}

TEST(FieldDigest, OfEachKindDependsOnAllParameters) {
  for (const FieldKind* kind : field_kinds()) check(*kind);
}

TEST(FieldDigest, OfEachNoiseDependsOnAllParameters) {
  for (const NoiseKind* kind : noises()) check(*kind);
}

TEST(FieldDigest, OfDifferentCasesDiffersUnlessValuesAreTheSame) {
  std::map<std::string, const SweepCase*> known;
  for (const SweepCase& c : all_sweep_cases()) {
    const auto [at, is_new] = known.emplace(c.field.digest().hex(), &c);
    EXPECT_TRUE(is_new || same_values(c.field, at->second->field))
        << c.label << " and " << at->second->label;
  }
}

Field ball_at(const Vec3d& at, double radius = 0.4) {
  return transformed(make("sphere", {{"radius", radius}}), Transform::translation(at));
}

Field row_of_balls(double last) {
  std::vector<Field> balls;
  for (int i = 0; i < 20; ++i) balls.push_back(ball_at(Vec3d(2 * i, 0, 0)));
  balls.push_back(ball_at(Vec3d(last, 5, 0)));
  return unite(std::move(balls));
}

// The reason for digests of restricted fields: an edit changes them only where it matters.
TEST(FieldDigest, OfRestrictedFieldsChangesOnlyNearAnEdit) {
  const Field before = row_of_balls(10), after = row_of_balls(20);
  EXPECT_NE(before.digest(), after.digest());
  const auto digest_at = [](const Field& field, const Vec3d& at) {
    return field.restricted({at, 1}).field.digest();
  };
  for (const double x : {0.0, 4.0, 30.0, 38.0})
    EXPECT_EQ(digest_at(before, {x, 0, 0}), digest_at(after, {x, 0, 0})) << x;
  for (const double x : {10.0, 20.0})
    EXPECT_NE(digest_at(before, {x, 5, 0}), digest_at(after, {x, 5, 0})) << x;
}

TEST(FieldDigest, OfRestrictedFieldsDoesNotDependOnHowTheyWereMade) {
  for (const SweepCase& c : all_sweep_cases()) {
    RandomStream random(RandomKey(5).at(c.label));
    const Ball ball{random_point(random, 1), random.uniform(0.1, 0.6)};
    EXPECT_EQ(c.field.restricted(ball).field.digest(), c.field.restricted(ball).field.digest())
        << c.label;
  }
}

TEST(FieldDigest, OfAModifierHasOnlyTheRestrictedChild) {
  const auto grown = [](double last) {
    return make("offset", {{"field", as_value(row_of_balls(last))}, {"by", 0.1}});
  };
  const auto digest_at = [](const Field& field) {
    return field.restricted({Vec3d(0), 1}).field.digest();
  };
  EXPECT_EQ(digest_at(grown(10)), digest_at(grown(20)));
}

TEST(FieldDigest, IsTheSameForAllThreads) {
  const Field field = row_of_balls(10);
  std::vector<std::string> all(1000);
  parallel_for(all.size(), [&](size_t i) { all[i] = field.node()->digest().hex(); });
  EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), 1u);
}

TEST(FieldDigest, OfADeferredFieldNeedsNoComputation) {
  static std::atomic<int> computed = 0;
  const auto made = [](double radius) {
    return deferred(
        {1, Exactness::exact, Box3d(Vec3d(-2), Vec3d(2)), 1}, {"growing"},
        [](double r) {
          ++computed;
          return ball_at({0, 0, 0}, r);
        },
        radius);
  };
  const Field field = made(0.5);
  const Digest before = field.digest();
  EXPECT_EQ(before, made(0.5).digest());
  EXPECT_NE(before, made(0.6).digest());
  EXPECT_EQ(computed, 0);
  field.value({0, 0, 0});
  EXPECT_EQ(computed, 1);
  EXPECT_EQ(unite({field, ball_at({1, 0, 0})}).digest(),
            unite({made(0.5), ball_at({1, 0, 0})}).digest());
}

// Expressions of grammars are thousands of nodes deep.
TEST(FieldDigest, OfADeepExpressionNeedsLittleStack) {
  Field field = ball_at({0, 0, 0});
  for (int i = 0; i < 3000; ++i) field = transformed(field, Transform::translation({0.001, 0, 0}));
  EXPECT_NE(field.digest(), ball_at({0, 0, 0}).digest());
}

}  // namespace
}  // namespace vug::field
