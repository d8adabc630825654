// SPDX-License-Identifier: Apache-2.0
// Valid combinations of dimensions and their results.
#include <vug/scene/arithmetic.h>
#include <vug/scene/units.h>

#include "parsing.h"

namespace vug::scene {
namespace {

/// The type of 2 [a] op 4 [b], or "fault".
std::string meet(char op, Dimension a, Dimension b) {
  Diagnostics diagnostics;
  const SourceLocation where;
  const auto value = arithmetic(op, Number{2, a}, Number{4, b}, {where, diagnostics});
  if (!value || value->empty()) return diagnostics.has_errors() ? "fault" : "silent";
  return value->type_name();
}

constexpr Dimension kNone = Dimension::none, kLength = Dimension::length, kAngle = Dimension::angle,
                    kRatio = Dimension::ratio, kPerLength = Dimension::per_length,
                    kTime = Dimension::time, kArea = Dimension::area, kVolume = Dimension::volume;

constexpr Dimension kAll[] = {kNone,
                              kLength,
                              kAngle,
                              kRatio,
                              kPerLength,
                              kTime,
                              kArea,
                              kVolume,
                              Dimension::per_area,
                              Dimension::frequency,
                              Dimension::mass,
                              Dimension::temperature,
                              Dimension::power,
                              Dimension::irradiance,
                              Dimension::luminous_flux,
                              Dimension::luminous_intensity,
                              Dimension::illuminance};

TEST(Units, SumsNeedEqualDimensions) {
  for (const Dimension a : kAll)
    for (const Dimension b : kAll) {
      const bool bare_angle = (a == kAngle && b == kNone) || (a == kNone && b == kAngle);
      const bool fits = (a == b || a == kNone || b == kNone) && !bare_angle;
      const Dimension result = a == kNone ? b : a;
      EXPECT_EQ(meet('+', a, b), fits ? Value(Number{0, result}).type_name() : "fault");
      EXPECT_EQ(meet('-', a, b), meet('+', a, b));
    }
}

TEST(Units, ProductsFollowDimensions) {
  EXPECT_EQ(meet('*', kLength, kNone), "a length");
  EXPECT_EQ(meet('*', kRatio, kLength), "a length");
  EXPECT_EQ(meet('/', kLength, kLength), "a number");
  EXPECT_EQ(meet('/', kNone, kLength), "a number per metre");
  EXPECT_EQ(meet('*', kPerLength, kLength), "a number");
  EXPECT_EQ(meet('/', kNone, kPerLength), "a length");
  EXPECT_EQ(meet('/', kAngle, kAngle), "a number");
  EXPECT_EQ(meet('*', kRatio, kRatio), "a ratio");
  EXPECT_EQ(meet('/', kRatio, kRatio), "a number");
  EXPECT_EQ(meet('*', kLength, kLength), "an area");
  EXPECT_EQ(meet('*', kArea, kLength), "a volume");
  EXPECT_EQ(meet('/', kVolume, kLength), "an area");
  EXPECT_EQ(meet('/', kVolume, kArea), "a length");
  EXPECT_EQ(meet('/', kNone, kArea), "a number per square metre");
  EXPECT_EQ(meet('*', kPerLength, kArea), "a length");
  EXPECT_EQ(meet('/', kNone, kTime), "a frequency");
  EXPECT_EQ(meet('*', Dimension::frequency, kTime), "a number");
  EXPECT_EQ(meet('/', Dimension::luminous_flux, kArea), "an illuminance");
  EXPECT_EQ(meet('*', Dimension::illuminance, kArea), "a luminous flux");
  EXPECT_EQ(meet('/', Dimension::power, kArea), "an irradiance");
  EXPECT_EQ(meet('*', kAngle, kLength), "fault");
  EXPECT_EQ(meet('*', kVolume, kLength), "fault");
  EXPECT_EQ(meet('/', Dimension::luminous_flux, kAngle), "fault");
}

TEST(Units, ADimensionDividedByItselfIsAPlainNumber) {
  for (const Dimension each : kAll) {
    EXPECT_EQ(product(each, each, -1), kNone);
    EXPECT_EQ(product(each, kNone), each == kRatio ? kNone : each);
    EXPECT_EQ(raised(each, 0), kNone);
    EXPECT_EQ(raised(each, 1), each == kRatio ? kNone : each);
  }
}

TEST(Units, PowersFollowDimensions) {
  EXPECT_EQ(raised(kLength, 2), kArea);
  EXPECT_EQ(raised(kLength, 3), kVolume);
  EXPECT_EQ(raised(kArea, 0.5), kLength);
  EXPECT_EQ(raised(kLength, -2), Dimension::per_area);
  EXPECT_EQ(raised(kTime, -1), Dimension::frequency);
  EXPECT_EQ(raised(kLength, 0.5), std::nullopt);
  EXPECT_EQ(raised(kLength, 4), std::nullopt);
  EXPECT_EQ(raised(kNone, 0.3), kNone);
}

TEST(Units, NamesOfUnitsAreValues) {
  const Document document = parsed("let a = 0.02/m\nlet b = 3*cm + 1 * ft\n");
  Resolver resolver;
  Diagnostics diagnostics;
  Evaluator evaluator(document, resolver, diagnostics);
  const Value a = evaluator.eval(*document.lets[0].value, evaluator.root());
  EXPECT_EQ(a.type_name(), "a number per metre");
  const Value b = evaluator.eval(*document.lets[1].value, evaluator.root());
  EXPECT_DOUBLE_EQ(b.get<Number>()->value, 0.03 + 0.3048);
}

TEST(Units, EveryUnitIsOneOfItsOwn) {
  for (const std::string& name : unit_names()) {
    EXPECT_TRUE(is_unit(name));
    const auto one = with_unit(1, name);
    ASSERT_TRUE(one);
    EXPECT_GT(one->value, 0);
    EXPECT_NE(one->dimension, kNone);
    EXPECT_DOUBLE_EQ(with_unit(7, name)->value, 7 * one->value);
  }
  EXPECT_FALSE(with_unit(1, "px"));
}

}  // namespace
}  // namespace vug::scene
