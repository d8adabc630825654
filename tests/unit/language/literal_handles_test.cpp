// SPDX-License-Identifier: Apache-2.0
// Numbers with a place in the scene: their roles from the schemas, their frames, their notation.
#include "texts.h"

#include <gtest/gtest.h>
#include <vug/language/kinds.h>
#include <vug/language/literal_handles.h>
#include <vug/loading/catalogue.h>

#include <cmath>
#include <map>
#include <set>

namespace vug::language {
namespace {

/// The handles of the statement at the mark.
StatementHandles handles_of(const MarkedText& text) {
  return handles_at(*text.analysis, text.position.line);
}
std::string names_of(const StatementHandles& found) {
  std::string out;
  for (const LiteralHandle& each : found.handles) out += (out.empty() ? "" : " ") + each.name;
  return out;
}
std::string reason_of(const StatementHandles& found, const std::string& name) {
  for (const MissingHandle& each : found.missing)
    if (each.name == name) return each.reason;
  return "";
}
void expect_near(const Vec3d& a, const Vec3d& b) {
  EXPECT_LT((a - b).length(), 1e-9) << a << " " << b;
}

TEST(LiteralHandles, LightsAndCamerasHaveThoseOfTheirSchemas) {
  const MarkedText lamp(
      "light lamp = |spot(center: (1m, 2m, 0), direction: (0, -1, 0), radius: 4cm, "
      "radiance: (1, 1, 1))\n");
  const StatementHandles found = handles_of(lamp);
  EXPECT_EQ(found.title, "light lamp");
  EXPECT_EQ(names_of(found), "center direction radius") << "a colour has no place";
  EXPECT_EQ(found.find("center").role, HandleRole::point);
  EXPECT_EQ(found.find("direction").role, HandleRole::direction);
  EXPECT_EQ(found.find("radius").role, HandleRole::length);
  expect_near(found.find("center").position(), {1, 2, 0});
  expect_near(found.find("direction").position(), {1, 2, 0});
  expect_near(found.find("radius").position(), {1.04, 2, 0});
  const MarkedText camera("camera main { eye (0, 1, 4)  |target (0, 0.5m, 0)  fov 60deg }\n");
  EXPECT_EQ(names_of(handles_of(camera)), "eye target");
}

TEST(LiteralHandles, DeformersMoveThem) {
  const MarkedText text(
      "let ball = sphere(radius: 50cm).scale(by: 2).translate((|1, 2, 3)).rotate(angle: 90deg)\n"
      "volume v = level_set(union([ball.translate(by: (0, 10, 0)), box()]), voxel: 5cm)\n");
  const StatementHandles found = handles_of(text);
  EXPECT_EQ(names_of(found), "radius by");
  // The rotation about y turns (1, 2, 3) to (3, 2, -1); the use of the let lifts it by 10.
  expect_near(found.find("by").position(), {3, 12, -1});
  expect_near(found.find("radius").place.point({0, 0, 0}), {3, 12, -1});
  expect_near(found.find("radius").position(), {3, 12, -2});
}

TEST(LiteralHandles, EqualNamesHaveNumbers) {
  const MarkedText text(
      "let solid = |union([box(size: (1, 2, 3)).translate((1, 0, 0)), "
      "sphere(40cm).translate((0, 1, 0))])\n");
  const StatementHandles found = handles_of(text);
  EXPECT_EQ(names_of(found), "size.x size.y size.z by[1] radius by[2]");
  expect_near(found.find("size.y").position(), {1, 1, 0});
}

TEST(LiteralHandles, PlacesHaveThoseOfTheirElements) {
  const MarkedText text(
      "place p { |of ball at [(1, 0, 2), pose(position: (0, 3, 0), yaw: 20deg)] }\n");
  const StatementHandles found = handles_of(text);
  EXPECT_EQ(names_of(found), "at position");
  expect_near(found.find("position").position(), {0, 3, 0});
  EXPECT_TRUE(found.missing.empty());
}

TEST(LiteralHandles, ExpressionsHaveNoneAndStateWhy) {
  const MarkedText text(
      "param HIGH = 2m in 1m..3m\n"
      "def post(x) = sphere(radius: 10cm).translate((1, 0, 0)).scale(by: x)\n"
      "light a = |sphere(center: (0, HIGH, 0), radius: 1cm..3cm)\n"
      "let bent = sphere(radius: 10cm).translate((1, 0, 0)).bend(rate: 0.2)\n");
  const StatementHandles found = handles_of(text);
  EXPECT_EQ(names_of(found), "");
  EXPECT_EQ(reason_of(found, "center"), "it is an expression");
  EXPECT_EQ(reason_of(found, "radius"), "it is drawn at random");
  EXPECT_THROW(found.find("center"), Error);
  EXPECT_EQ(reason_of(handles_at(*text.analysis, 2), "by"), "the calls of the function place it");
  EXPECT_EQ(reason_of(handles_at(*text.analysis, 4), "by"), "'bend' around it moves it");
  EXPECT_EQ(handles_at(*text.analysis, 1).title, "") << "a param has no place";
}

TEST(LiteralHandles, OtherNumbersKeepTheNotation) {
  EXPECT_EQ(number_text("1.5m", 1.7333, 0.004), "1.733m");
  EXPECT_EQ(number_text("1.50m", 1.7, 0.1), "1.70m");
  EXPECT_EQ(number_text("150cm", 1.7333, 0.004), "173.3cm");
  EXPECT_EQ(number_text("0", 1.2, 0.1, "m"), "1.2m");
  EXPECT_EQ(number_text("3", -0.0001, 0.1), "0");
  const MarkedText text("light l = |sphere(center: (-1.5m, 0, 150cm))\n");
  const StatementHandles found = handles_of(text);
  EXPECT_EQ(number_texts(found.find("center"), {-1.5, 0.25, 1.4}, 0.01),
            (std::vector<std::string>{"-1.5m", "0.25m", "140cm"}));
  const MarkedText plain("light l = |sphere(center: (1.5m, 0, 0.5))\n");
  EXPECT_EQ(number_texts(handles_of(plain).find("center"), {1.5, 0.25, 1.4}, 0.01),
            (std::vector<std::string>{"1.5m", "0.25m", "1.4"}));
}

TEST(LiteralHandles, SizesStayAboveTheirLimit) {
  const MarkedText text("light l = |sphere(center: (0, 0, 0), radius: 10cm)\n");
  EXPECT_EQ(number_texts(handles_of(text).find("radius"), {-5}, 0.01),
            std::vector<std::string>{"1cm"});
}

/// All vectors of the catalogue: their bounds and descriptions separate positions and directions
/// from colours, factors and coordinates of files. A new kind needs no entry here unless its
/// parameter is one of the exceptions.
TEST(LiteralHandles, RolesFollowFromTheSchemas) {
  const std::set<std::string> placeless = {"nodes_links.origin", "survey.origin", "pose.stretch",
                                           "pattern.across", "pattern.along"};
  const std::set<std::string> colours = {"albedo", "emission", "radiance", "tint",  "ground",
                                         "color",  "line",     "colors",   "counts"};
  for (const KindInfo* kind : loading::find_kinds())
    for (const ParamInfo& param : kind->params) {
      if (param.type != "vector" || kind->category == "curve") continue;
      const std::string name = kind->name + "." + param.name;
      const auto role = handle_role(param, kind->category);
      const bool colour = colours.count(param.name) || kind->category == "rule" ||
                          param.dimension == Dimension::irradiance;
      EXPECT_EQ(role.has_value(), !placeless.count(name) && !colour) << name;
      if (role && param.dimension == Dimension::none) {
        EXPECT_EQ(*role, HandleRole::direction) << name;
      }
      if (param.name == "size" || param.name == "radii") {
        EXPECT_EQ(role, HandleRole::extent) << name;
      }
    }
}

TEST(LiteralHandles, EachStatementOfTheScenesHasFiniteOnes) {
  for (const auto& scene : data_scenes()) {
    Workspace workspace(with_data());
    const AnalysisPtr analysis = workspace.analyse(scene);
    std::set<int> lines;
    for (const scene::Declaration& each : analysis->document.declarations)
      if (each.extent.file == analysis->file) lines.insert(each.extent.line);
    for (const scene::Let& each : analysis->document.lets)
      if (each.extent.file == analysis->file) lines.insert(each.extent.line);
    for (const int line : lines) {
      std::set<std::string> names;
      for (const LiteralHandle& each : handles_at(*analysis, line).handles) {
        EXPECT_TRUE(std::isfinite(each.position().length())) << scene << ":" << line;
        EXPECT_TRUE(names.insert(each.name).second) << scene << ":" << line << " " << each.name;
        EXPECT_EQ(each.numbers.size(),
                  each.role == HandleRole::point || each.role == HandleRole::direction ? 3u : 1u);
      }
    }
  }
}

}  // namespace
}  // namespace vug::language
