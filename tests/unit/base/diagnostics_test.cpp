// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parameter_synonyms.h>
#include <vug/base/schema.h>

#include <gtest/gtest.h>

namespace vug {
namespace {

TEST(NearestName, FindsTyposOnly) {
  const std::vector<std::string> known = {"radius", "height", "tube"};
  EXPECT_EQ(nearest_name("raduis", known), "radius");
  EXPECT_EQ(nearest_name("tub", known), "tube");
  EXPECT_EQ(nearest_name("N", {"m", "n"}), "n");
  EXPECT_EQ(nearest_name("colour", known), "");
  EXPECT_EQ(suggestion("colour", known), "known: radius, height, tube");
}

struct Ring {
  double radius = 1;
  double angle = 0;
  Vec3d centre{0, 0, 0};
};

Schema<Ring> ring_schema() {
  Schema<Ring> schema("ring", "test");
  schema.param("radius", &Ring::radius, positive_length("of the ring"))
      .param("angle", &Ring::angle, {.doc = "turn", .dimension = Dimension::angle})
      .param("centre", &Ring::centre, any_length("middle"));
  return schema;
}

std::string first_fault(const Arguments& arguments) {
  Diagnostics diagnostics;
  ring_schema().bind(arguments, {}, diagnostics);
  return diagnostics.all().empty() ? "" : diagnostics.all()[0].message;
}

TEST(Schema, BindsByNameAndPosition) {
  Diagnostics diagnostics;
  const auto ring = ring_schema().bind(
      {{"", Value(2.0), {}}, {"centre", Value(Vec3d(1, 2, 3)), {}}}, {}, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  ASSERT_TRUE(ring);
  EXPECT_EQ(ring->radius, 2);
  EXPECT_EQ(ring->centre, Vec3d(1, 2, 3));
}

TEST(Schema, ReportsEachError) {
  EXPECT_EQ(first_fault({{"raduis", Value(1.0), {}}}), "'ring' has no parameter 'raduis'");
  EXPECT_EQ(first_fault({{"radius", Value(0.0), {}}}), "'radius' must be above 0, not 0");
  EXPECT_EQ(first_fault({{"radius", Value(NAN), {}}}), "'radius' is not a finite number");
  EXPECT_EQ(first_fault({{"radius", Value("big"), {}}}), "'radius' expects a number, not a text");
  EXPECT_EQ(first_fault({{"angle", Value(30.0), {}}}), "'angle' is an angle and needs a unit");
  EXPECT_EQ(first_fault({{"radius", Value(Number{1, Dimension::angle}), {}}}),
            "'radius' expects a length, not an angle");
  EXPECT_EQ(first_fault({{"", Value(1.0), {}}, {"radius", Value(1.0), {}}}),
            "'radius' is given twice");
}

TEST(Schema, BoundsHaveTheUnitOfTheGivenValue) {
  EXPECT_EQ(first_fault({{"radius", Value(-2.0), {}}}), "'radius' must be above 0, not -2m");
  Schema<Ring> schema("ring", "test");
  schema.param("radius", &Ring::radius, {.doc = "", .dimension = Dimension::angle, .max = kPi / 2});
  Diagnostics angle, share;
  schema.bind({{"radius", Value(Number{kPi, Dimension::angle}), {}}}, {}, angle);
  EXPECT_EQ(angle.all().at(0).message, "'radius' must be at most 90deg, not 180deg");
  Schema<Ring> plain("ring", "test");
  plain.param("radius", &Ring::radius, {.doc = "", .max = 1});
  plain.bind({{"radius", Value(Number{1.2, Dimension::ratio}), {}}}, {}, share);
  EXPECT_EQ(share.all().at(0).message, "'radius' must be at most 100%, not 120%");
}

TEST(Schema, NumbersWithoutUnitsHaveHintsForThoseWithAUnit) {
  struct Drip {
    double age = 1000;
    int count = 1;
  };
  Schema<Drip> schema("drip", "test");
  schema.param("age", &Drip::age, {.doc = "years", .min = 1, .max = 1e7});
  schema.param("count", &Drip::count, {.doc = "", .min = 0});
  const auto fault = [&](const char* name, const Value& value) {
    Diagnostics diagnostics;
    schema.bind({{name, value, {}}}, {}, diagnostics);
    return diagnostics.all().at(0).message + "; " + diagnostics.all().at(0).hint;
  };
  EXPECT_EQ(fault("age", Number{0.5, Dimension::ratio}),
            "'age' must be at least 1, not 50%; 50% is 0.5; write a number without '%'");
  EXPECT_EQ(fault("age", Number{20, Dimension::time}),
            "'age' expects a number, not a time; write it as a number without a unit");
  EXPECT_EQ(fault("count", 1e12),
            "'count' expects a whole number, not 1000000000000; whole numbers reach from "
            "-2147483647 to 2147483647");
  EXPECT_EQ(fault("count", 2.5), "'count' expects a whole number, not 2.5; ");
}

TEST(Schema, ListElementsAreRangeChecked) {
  struct Picture {
    std::vector<int> size;
  };
  Schema<Picture> schema("picture", "test");
  schema.param("size", &Picture::size, {.doc = "", .min = 1, .max = 100});
  const auto message = [&](const List& size) {
    Diagnostics diagnostics;
    schema.bind({{"size", Value(size), {}}}, {}, diagnostics);
    return diagnostics.all().empty() ? "" : diagnostics.all()[0].message;
  };
  EXPECT_EQ(message({1, 100}), "");
  EXPECT_EQ(message({10, 0}), "the 2nd of 'size' must be at least 1, not 0");
  EXPECT_EQ(message({101, 10}), "the 1st of 'size' must be at most 100, not 101");
  EXPECT_EQ(message({10, Number{2, Dimension::length}}),
            "the 2nd of 'size' expects a number, not a length");
  EXPECT_EQ(message({10, 2.5}), "'size' expects a list of whole numbers, and the 2nd is 2.5");
  EXPECT_EQ(message({1, 2, "three"}),
            "'size' expects a list of whole numbers, and the 3rd is a text");
  List many(25, 1);
  many[10] = 0;
  EXPECT_EQ(message(many), "the 11th of 'size' must be at least 1, not 0");
  many[10] = 1, many[22] = 0;
  EXPECT_EQ(message(many), "the 23rd of 'size' must be at least 1, not 0");
}

TEST(Schema, DefaultsHaveUnits) {
  struct Arc {
    double radius = 0.25;
    double angle = kPi / 4;
    double rate = 0.5;
    double count = 0.52;
    Vec3d centre{0, -1.5, 0};
    std::vector<double> steps = {0.1, 0};
  };
  Schema<Arc> schema("arc", "test");
  schema.param("radius", &Arc::radius, any_length(""))
      .param("angle", &Arc::angle, {.doc = "", .dimension = Dimension::angle})
      .param("rate", &Arc::rate, {.doc = "", .dimension = Dimension::per_length})
      .param("count", &Arc::count, {.doc = ""})
      .param("centre", &Arc::centre, any_length(""))
      .param("steps", &Arc::steps, any_length(""));
  std::vector<std::string> defaults;
  for (const ParamInfo& param : schema.info().params) defaults.push_back(param.fallback);
  EXPECT_EQ(defaults, (std::vector<std::string>{"0.25m", "45deg", "0.5/m", "0.52", "(0, -1.5m, 0)",
                                                "[0.1m, 0]"}));
}

TEST(SourceLocation, RangesNestAndJoin) {
  const SourceLocation first{"a.vug", 2, 5, 2, 9}, last{"a.vug", 3, 1, 3, 4};
  const SourceLocation both = first.up_to(last);
  EXPECT_EQ(range_text(both), "a.vug:2:5-3:4");
  EXPECT_TRUE(both.contains(first) && both.contains(last) && both.contains(both));
  EXPECT_FALSE(first.contains(both) || first.contains(last));
  EXPECT_FALSE(both.contains({"b.vug", 2, 5, 2, 9}));
  const SourceLocation position{"a.vug", 2, 6};
  EXPECT_FALSE(both.contains(position) || position.has_end());
  EXPECT_EQ(range_text(position), "a.vug:2:6");
}

TEST(Parameters, OfOtherProgramsAreKnown) {
  EXPECT_EQ(parameter_for("samples", {"size", "spp"}), "spp");
  EXPECT_EQ(parameter_for("position", {"eye", "target"}), "eye");
  EXPECT_EQ(parameter_for("position", {"center", "radius"}), "center");
  EXPECT_EQ(parameter_for("color", {"radiance", "radius"}), "radiance");
  EXPECT_EQ(parameter_for("color", {"radius"}), "");
  EXPECT_EQ(parameter_for("colander", {"radiance"}), "");
}

}  // namespace
}  // namespace vug
