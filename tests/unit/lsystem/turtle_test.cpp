// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/lsystem/turtle.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

namespace vug::lsystem {
namespace {

/// Parses a word such as "F(1,0.1) + leaf(2)": blanks between modules, parameters in base units.
struct Text {
  explicit Text(const std::string& text) {
    for (size_t at = 0; at < text.size();) {
      const size_t end = std::min(text.find(' ', at), text.size());
      std::string module = text.substr(at, end - at);
      at = end + 1;
      if (module.empty()) continue;
      std::vector<double> numbers;
      if (const size_t open = module.find('('); open != std::string::npos) {
        for (size_t from = open + 1; from < module.size();) {
          numbers.push_back(std::stod(module.substr(from)));
          from = std::min(module.find(',', from), module.size() - 1) + 1;
        }
        module.resize(open);
      }
      word.append(alphabet.add(module, numbers.size()), numbers);
    }
  }
  Alphabet alphabet;
  Word word;
};

Drawing drawn(const std::string& text, const TurtleOptions& options = {}) {
  const Text t(text);
  return draw(t.word, t.alphabet, options);
}

#define EXPECT_CLOSE(a, b) EXPECT_LT(((a) - (b)).length(), 1e-12) << (a)

TEST(Turtle, TurnsToTheLeftAroundASquare) {
  TurtleOptions options;
  options.angle = kPi / 2;
  const Drawing d = drawn("F + F + F + F", options);
  ASSERT_EQ(d.axes.size(), 1u);
  const auto& s = d.axes[0].stations;
  ASSERT_EQ(s.size(), 5u);
  EXPECT_CLOSE(s[1].position, Vec3d(0, 1, 0));
  EXPECT_CLOSE(s[2].position, Vec3d(-1, 1, 0));
  EXPECT_CLOSE(s[4].position, Vec3d(0, 0, 0));
  EXPECT_EQ(s[4].along, 4);
}

TEST(Turtle, RotatesAboutItsLeftAndUp) {
  const double quarter = kPi / 2;
  const auto heading = [](const std::string& text) {
    const Drawing d = drawn(text + " F");
    return d.axes[0].stations[1].position;
  };
  const std::string q = fmt::format("({})", quarter);
  TurtleOptions options;
  const auto near = [&](const std::string& text, const Vec3d& wanted) {
    EXPECT_LT((heading(text) - wanted).length(), 1e-5) << text;
  };
  near("+" + q, {-1, 0, 0});
  near("-" + q, {1, 0, 0});
  near("&" + q, {0, 0, -1});
  near("^" + q, {0, 0, 1});
  near("|", {0, -1, 0});
  near("/" + q + " +" + q, {0, 0, 1});    // its left points to +z
  near("\\" + q + " +" + q, {0, 0, -1});  // and to -z
}

TEST(Turtle, BranchesKnowTheirParents) {
  const Drawing d = drawn("F(1) node [ +(1) F(1) [ -(1) F(1) ] ] F(2) [ [ F ] ]");
  ASSERT_EQ(d.axes.size(), 4u);
  EXPECT_EQ(d.axes[0].stations.size(), 3u);  // it continues after the branch
  EXPECT_EQ(d.axes[0].length(), 3);
  EXPECT_EQ(d.axes[1].parent, 0u);
  EXPECT_EQ(d.axes[1].parent_along, 1);
  EXPECT_EQ(d.axes[1].order, 1);
  EXPECT_EQ(d.axes[2].parent, 1u);
  EXPECT_EQ(d.axes[2].order, 2);
  EXPECT_EQ(d.axes[3].order, 1);  // empty brackets do not increase the order
  ASSERT_EQ(d.axes[0].nodes.size(), 1u);
  EXPECT_EQ(d.axes[0].nodes[0].along, 1);
  ASSERT_EQ(d.axes[0].nodes[0].branches.size(), 1u);
  EXPECT_CLOSE(d.axes[0].nodes[0].branches[0], Vec3d(-std::sin(1), std::cos(1), 0));
}

TEST(Turtle, MovingWithoutDrawingStartsAnAxis) {
  const Drawing d = drawn("F f F");
  ASSERT_EQ(d.axes.size(), 2u);
  EXPECT_EQ(d.axes[1].parent, Axis::kNone);
  EXPECT_EQ(d.axes[1].stations[0].position, Vec3d(0, 2, 0));
}

TEST(Turtle, RadiiTaper) {
  const Drawing d = drawn("F(1,0.5) F(1,0.2) [ F(1,0.1) ] [ !(0.3) F(1,0.1) ] F");
  EXPECT_EQ(d.axes[0].stations[0].radius, 0.5);
  EXPECT_EQ(d.axes[0].stations[1].radius, 0.5);
  EXPECT_EQ(d.axes[0].stations[2].radius, 0.2);
  EXPECT_EQ(d.axes[0].stations[3].radius, 0.2);
  EXPECT_EQ(d.axes[1].stations[0].radius, 0.1);   // a branch has its own radius
  EXPECT_EQ(d.axes[2].stations[0].radius, 0.15);  // ! is a diameter
  EXPECT_EQ(d.axes[2].stations[1].radius, 0.1);
  EXPECT_EQ(drawn("node F(1,0.5)").axes[0].stations[0].radius, 0.5);
}

TEST(Turtle, PolygonsHaveTheVisitedCorners) {
  TurtleOptions options;
  options.angle = kPi / 3;
  const Drawing leaf = drawn("[ ' { - f + f + f - | - f + f + f } ] F", options);
  ASSERT_EQ(leaf.polygons.size(), 1u);
  EXPECT_EQ(leaf.polygons[0].corners.size(), 6u);
  EXPECT_EQ(leaf.polygons[0].colour, 1);
  const Drawing dots = drawn("{ . G(1) . + G(1) . }", options);
  ASSERT_EQ(dots.polygons.size(), 1u);
  EXPECT_EQ(dots.polygons[0].corners.size(), 3u);
  EXPECT_EQ(dots.axes.size(), 1u);
}

TEST(Turtle, DollarLevelsItsLeft) {
  const Drawing d = drawn("&(0.7) /(1.1) +(0.4) $ leaf", {.instances = {"leaf"}});
  ASSERT_EQ(d.instances.size(), 1u);
  const Frame& f = d.instances[0].frame;
  EXPECT_NEAR(f.normal.y, 0, 1e-12);
  EXPECT_GT(f.binormal.y, 0);
}

TEST(Turtle, TropismRotatesByElasticityTimesTorque) {
  TurtleOptions options;
  options.tropism = Vec3d(0, -1, 0);
  options.elasticity = 0.22;
  const Drawing d = drawn("+(1) F F", options);
  const Vec3d first = d.axes[0].stations[1].position;
  const Vec3d second = d.axes[0].stations[2].position - first;
  EXPECT_NEAR(std::acos(first.y), 1, 1e-12);
  EXPECT_NEAR(std::acos(second.y), 1 + 0.22 * std::sin(1.0), 1e-12);
  options.elasticity = 0;
  EXPECT_EQ(drawn("elasticity(0.22) +(1) F F", {.elasticity = 0}).axes[0].stations[2].position,
            d.axes[0].stations[2].position);
}

TEST(Turtle, FollowsAGuideByArcLength) {
  TurtleOptions options;
  options.guides = {drooping(4, 0.1, 2.2, 0.3, 0.5)};
  const ArcBezier guide(options.guides[0]);
  const Drawing d = drawn("guide(0) F(1.5,0.1) /(2) F(1,0.1) node F(1.5,0.1)", options);
  const Axis& axis = d.axes[0];
  EXPECT_NEAR(axis.length(), 4, 1e-12);
  EXPECT_NEAR(axis.nodes[0].along, 2.5, 1e-12);
  for (const Station& s : axis.stations) {
    EXPECT_LT((s.position - guide.point(s.along)).length(), 1e-9);
    EXPECT_LT((s.frame.tangent - guide.tangent(s.along)).length(), 1e-9);
  }
  EXPECT_GT(axis.stations.size(), 30u);  // fine enough for the bend
}

TEST(Turtle, GoesStraightBeyondAGuideAndBranchesDoNotFollow) {
  TurtleOptions options;
  options.guides = {drooping(1, 0, 1, 0, 0.5)};
  const Drawing d = drawn("guide(0,2) F(3) [ F(1) ]", options);
  const auto& s = d.axes[0].stations;
  EXPECT_NEAR((s.back().position - s[s.size() - 2].position).length(), 1, 1e-9);
  EXPECT_EQ(d.axes[1].stations.size(), 2u);
}

TEST(Turtle, InstancesHaveTheTurtlesFrame) {
  const Drawing d = drawn("F(2) leaf(0.5,7,8)", {.instances = {"flower", "leaf"}});
  ASSERT_EQ(d.instances.size(), 1u);
  const Instance& leaf = d.instances[0];
  EXPECT_EQ(d.names[leaf.name], "leaf");
  EXPECT_EQ(leaf.parameters, (std::vector<double>{7, 8}));
  const auto at = [&](const Vec3d& p) { return p * leaf.to_world(); };
  EXPECT_CLOSE(at({0, 0, 0}), Vec3d(0, 2, 0));
  EXPECT_CLOSE(at({0, 1, 0}), Vec3d(0, 2.5, 0));
  EXPECT_CLOSE(at({1, 0, 0}), Vec3d(0.5, 2, 0));
  EXPECT_CLOSE(at({0, 0, 1}), Vec3d(0, 2, 0.5));
}

TEST(Turtle, ReportsErrorsWithTheirLocation) {
  const auto message = [](const std::string& text) -> std::string {
    try {
      drawn(text);
      return "";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::bad_input);
      return error.what();
    }
  };
  EXPECT_EQ(message("F ]"), "a ']' without a matching '[', at ']', module 2 of the word");
  EXPECT_NE(message("F [ F"), "");
  EXPECT_NE(message("{ f"), "");
  EXPECT_NE(message("."), "");
  EXPECT_NE(message("F(nan)"), "");
  EXPECT_NE(message("F(inf,1)"), "");
  EXPECT_NE(message("F(-1)"), "");
  EXPECT_NE(message("F(1,-1)"), "");
  EXPECT_NE(message("!(-1)"), "");
  EXPECT_NE(message("guide(0)"), "");
  EXPECT_NE(message("age"), "");
  EXPECT_EQ(message("Q(nan) F"), "");  // ignored modules may have any parameters
  EXPECT_EQ(message("F(9e8) F(2e8)"),
            "the turtle is more than 1000000000 m from its start, at 'F(200000000)', module 2 of "
            "the word");
  EXPECT_NE(message("f(1e308) f(1e308)"), "");
  EXPECT_NE(message("!(1e30) F"), "");
  EXPECT_NE(message("node(-1)"), "");
  EXPECT_NE(message("node(1e9)"), "");
}

TEST(Turtle, RotatesByAnyAngle) {
  for (const char* angle : {"1e5", "1e6", "-1e17", "1e300"}) {
    const Frame frame = drawn("+(" + std::string(angle) + ") F").axes.at(0).stations.at(1).frame;
    EXPECT_NEAR(frame.tangent.length(), 1, 1e-12) << angle;
    EXPECT_NEAR(frame.tangent.dot(frame.normal), 0, 1e-12) << angle;
  }
}

TEST(Turtle, RejectsNonFiniteOptions) {
  TurtleOptions options;
  options.width = -1;
  EXPECT_THROW(drawn("F", options), Error);
  options = TurtleOptions();
  options.step = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(drawn("F", options), Error);
}

TEST(Turtle, AStemOfZeroLengthSetsTheRadius) {
  const Drawing drawing = drawn("F(0,0.2) F(1,0.1)");
  ASSERT_EQ(drawing.axes.size(), 1u);
  ASSERT_EQ(drawing.axes[0].stations.size(), 2u);
  EXPECT_EQ(drawing.axes[0].stations[0].radius, 0.2);
  EXPECT_EQ(drawing.axes[0].stations[1].radius, 0.1);
}

TEST(Turtle, VisitsTheRequestedModules) {
  const Text t("F ?P(0,0,0) [ +(1) F ?P(0,0,0) ] F");
  std::map<size_t, Vec3d> seen;
  visit_poses(t.word, t.alphabet, {}, {*t.alphabet.find("?P", 3)},
              [&](size_t at, const TurtlePose& pose) { seen[at] = pose.position; });
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_CLOSE(seen[1], Vec3d(0, 1, 0));
  EXPECT_CLOSE(seen[5], Vec3d(-std::sin(1), 1 + std::cos(1), 0));
}

TEST(Turtle, TheSameForAnyNumberOfThreads) {
  TurtleOptions options;
  options.guides = {drooping(4, 0.1, 2.2, 0.3, 0.5)};
  options.elasticity = 0.1;
  const std::string text = "guide(0) F(1) [ +(0.3) F(0.4) ] F(2) [ &(0.3) /(1) F(0.4) ] F(1)";
  const Drawing alone = drawn(text, options);
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads, [&] {
      std::vector<Drawing> all(16);
      parallel_for(all.size(), [&](size_t i) { all[i] = drawn(text, options); });
      for (const Drawing& each : all) EXPECT_EQ(each, alone);
    });
  }
}

}  // namespace
}  // namespace vug::lsystem
