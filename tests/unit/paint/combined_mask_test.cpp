// SPDX-License-Identifier: Apache-2.0
// Masks that combine masks: their values, and the attributes that they read.
#include <vug/base/maths.h>
#include <vug/paint/kind.h>

#include <gtest/gtest.h>

namespace vug::paint {
namespace {

struct Carried : Attributes {
  std::optional<Vec3d> read(std::string_view name) const override {
    if (name == "wet") return Vec3d(0.25);
    if (name == "Cd") return Vec3d(0.5, 0.25, 0);
    return std::nullopt;
  }
};

double value(const Mask& mask, const Vec3d& normal = {0, 1, 0}) {
  const Carried carried;
  EvalPoint point{Vec3d(0), normal};
  point.attributes = &carried;
  return (*mask)(point);
}

Value made(const std::string& kind, const NamedValues& parameters) {
  return ValueTraits<Mask>::write(make_product(masks(), kind, parameters));
}
Mask mask(const std::string& kind, const NamedValues& parameters) {
  return make_product(masks(), kind, parameters);
}

TEST(CombinedMasks, CombineTheirInputs) {
  const Value wet = made("value", {{"name", "wet"}});
  const Value list(List{wet, Value(0.5), Value(0.75)});
  EXPECT_EQ(value(mask("value", {{"name", "wet"}, {"scale", 2}})), 0.5);
  EXPECT_EQ(value(mask("value", {{"name", "Cd"}})), 0.25);
  EXPECT_EQ(value(mask("value", {{"name", "dry"}, {"otherwise", 0.125}})), 0.125);
  EXPECT_EQ(value(mask("add", {{"of", list}})), 1.5);
  EXPECT_EQ(value(mask("multiply", {{"of", list}})), 0.25 * 0.5 * 0.75);
  EXPECT_EQ(value(mask("multiply", {{"of", List{Value(0), wet}}})), 0);
  EXPECT_EQ(value(mask("greatest", {{"of", list}})), 0.75);
  EXPECT_EQ(value(mask("least", {{"of", list}})), 0.25);
  EXPECT_EQ(value(mask("invert", {{"mask", wet}})), 0.75);
  EXPECT_EQ(value(mask("ramp", {{"mask", wet}, {"from", 0}, {"to", 0.5}})), 0.5);
  EXPECT_EQ(value(mask("ramp", {{"mask", wet}, {"from", 0.3}, {"to", 0.3}})), 0);
  EXPECT_THROW(mask("greatest", {{"of", Value(List{})}}), Error);
}

TEST(CombinedMasks, FacingUsesTheAngleToADirection) {
  const Mask facing = mask("facing", {{"toward", Vec3d(0, 0, 2)}});
  EXPECT_EQ(value(facing, {0, 0, 1}), 1);
  EXPECT_EQ(value(facing, {0, 0, -1}), 0);
  EXPECT_NEAR(value(facing, {std::sqrt(0.5), 0, std::sqrt(0.5)}), 0.5, 1e-12);
  EXPECT_NEAR(value(facing, {0, 1, 0}), 0, 1e-12);
  EXPECT_THROW(mask("facing", {{"toward", Vec3d(0)}}), Error);
}

TEST(CombinedMasks, ReadTheAttributesOfTheirInputs) {
  for (const std::string kind : {"add", "greatest", "least", "multiply"}) {
    const Mask all = mask(kind, {{"of", List{made("value", {{"name", "wet"}}), Value(1),
                                             made("attribute", {{"name", "moss"}})}}});
    ASSERT_EQ(all->uses().size(), 2u) << kind;
    EXPECT_EQ(all->uses()[0].attribute, "wet");
    EXPECT_EQ(all->uses()[1].attribute, "moss");
  }
  const Value wet = made("attribute", {{"name", "wet"}});
  for (const std::string kind : {"invert", "ramp", "between"})
    EXPECT_EQ(mask(kind, {{"mask", wet}})->uses().size(), 1u) << kind;
  const Paint layer =
      make_product(paints(), "layer", {{"under", Vec3d(0)}, {"over", Vec3d(1)}, {"mask", wet}});
  EXPECT_EQ(layer->uses().size(), 1u);
  EXPECT_EQ(mask("brightness", {{"paint", ValueTraits<Paint>::write(layer)}})->uses().size(), 1u);
  EXPECT_TRUE(mask("slope", {})->uses().empty());
}

}  // namespace
}  // namespace vug::paint
