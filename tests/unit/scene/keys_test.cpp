// SPDX-License-Identifier: Apache-2.0
// Values that depend on the frame.
#include <vug/scene/keys.h>

#include "fake_resolver.h"
#include "parsing.h"

namespace vug::scene {
namespace {

struct KeyedValue {
  std::string value;  ///< Value of `let x`; errors as "! message".
  bool moves = false;
};

KeyedValue read_at(const std::string& text, double frame) {
  Diagnostics diagnostics;
  const Document document = parse(text, "t.vug", diagnostics);
  FakeResolver resolver;
  EvaluatorOptions options;
  options.frame = frame;
  Evaluator evaluator(document, resolver, diagnostics, options);
  KeyedValue out;
  if (const Let* x = document.find_let("x"))
    out.value = to_string(evaluator.eval(*x->value, evaluator.root()));
  for (const Diagnostic& one : diagnostics.all()) out.value += "! " + one.message;
  out.moves = resolver.frame_uses() > 0;
  return out;
}

std::string x_at(const std::string& expression, double frame) {
  return read_at("let x = " + expression, frame).value;
}

TEST(Keys, AreInterpolatedLinearly) {
  const std::string keys = "keys(1: 50cm, 11: 2.5m, 21: 2m)";
  for (const auto& [frame, value] :
       {std::pair(-4.0, "0.5m"), std::pair(1.0, "0.5m"), std::pair(6.0, "1.5m"),
        std::pair(11.0, "2.5m"), std::pair(16.0, "2.25m"), std::pair(99.0, "2m")})
    EXPECT_EQ(x_at(keys, frame), value) << frame;
  EXPECT_EQ(x_at("keys(0: (0, 1, 2), 10: (1m, 2m, 3m))", 5), "(0.5m, 1.5m, 2.5m)");
  EXPECT_EQ(x_at("keys(-10: 0, 10: 1rad)", 0), "0.5rad");
  EXPECT_EQ(x_at("2 * keys(0: 1, 0.5: 3) + frame", 0.25), "4.25");
}

TEST(Keys, StepsHoldAnyValue) {
  EXPECT_EQ(x_at("keys(step, 1: \"a\", 5: \"b\")", 4.9), "\"a\"");
  EXPECT_EQ(x_at("keys(step, 1: 1m, 5: 2m)", 5), "2m");
  EXPECT_EQ(x_at("keys(step, 1: true, 5: false)", 0), "true");
}

TEST(Keys, SmoothCurvesAreFlatAtEndsAndNeverOvershoot) {
  const std::vector<double> frames = {0, 4, 5, 9, 20}, values = {0, 1, 8, 8, 3};
  const auto at = [&](double f) { return interpolate_keys(frames, values, Ease::smooth, f); };
  for (size_t i = 0; i < frames.size(); ++i) EXPECT_DOUBLE_EQ(at(frames[i]), values[i]);
  for (size_t i = 0; i + 1 < frames.size(); ++i) {
    const double low = std::min(values[i], values[i + 1]),
                 high = std::max(values[i], values[i + 1]);
    double before = values[i];
    for (double t = 0; t <= 1; t += 1.0 / 64) {
      const double v = at(frames[i] + t * (frames[i + 1] - frames[i]));
      EXPECT_GE(v, low - 1e-12);
      EXPECT_LE(v, high + 1e-12);
      EXPECT_GE((v - before) * (values[i + 1] - values[i]), -1e-12) << "not monotone between keys";
      before = v;
    }
  }
  constexpr double h = 1e-6;
  EXPECT_NEAR((at(h) - at(0)) / h, 0, 1e-4) << "flat at the first key";
  EXPECT_NEAR((at(20) - at(20 - h)) / h, 0, 1e-4) << "flat at the last key";
  EXPECT_NEAR((at(4 + h) - at(4)) / h, (at(4) - at(4 - h)) / h, 1e-3) << "no corner between";
  EXPECT_EQ(x_at("keys(smooth, 0: 0, 2: 1)", 0.5), "0.15625");  // 3 t^2 - 2 t^3 at a quarter
}

TEST(Keys, TrackFrameDependence) {
  EXPECT_FALSE(read_at("let x = 1 + 2", 3).moves);
  EXPECT_TRUE(read_at("let x = frame", 3).moves);
  EXPECT_TRUE(read_at("let x = keys(1: 2)", 3).moves);
  EXPECT_TRUE(read_at("let y = frame\nlet x = 2 * y", 3).moves);
}

TEST(Keys, EachKeyDrawsItsOwnNumber) {
  const std::string keys = "keys(1: 0..1, 2: 0..1)";
  EXPECT_NE(x_at(keys, 1), x_at(keys, 2));
  EXPECT_EQ(x_at(keys, 1), x_at("keys(1: 0..1, 2: 0..1, 3: 5)", 1))
      << "a further key changes nothing";
}

TEST(Keys, ReportErrors) {
  EXPECT_EQ(x_at("keys()", 1), "! 'keys' needs at least one key");
  EXPECT_EQ(x_at("keys(1, 2)", 1), "! 'keys' needs frames with their values");
  EXPECT_EQ(x_at("keys(a: 2)", 1), "! 'keys' needs frames with their values");
  EXPECT_EQ(x_at("keys(5: 1, 3: 2)", 1), "! the key at frame 3 comes after that at 5");
  EXPECT_EQ(x_at("keys(5: 1, 5: 2)", 1), "! the key at frame 5 comes after that at 5");
  EXPECT_EQ(x_at("keys(1: 1m, 2: 3deg)", 1), "! keys cannot mix a length and an angle");
  EXPECT_EQ(x_at("keys(1: 1m, 2: (1, 2, 3))", 1), "! keys cannot mix a length and a vector");
  EXPECT_EQ(x_at("keys(1: true, 2: false)", 1), "! true or false cannot be interpolated");
  EXPECT_EQ(x_at("keys(1s: 1)", 1), "! a key must be a frame number without a unit");
  EXPECT_EQ(read_at("let frame = 2", 1).value,
            "! 'frame' is a keyword and cannot be used as a name");
}

}  // namespace
}  // namespace vug::scene
