// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/format.h>

#include "fake_resolver.h"
#include "parsing.h"

namespace vug::scene {
namespace {

constexpr const char* kCave = R"(
param WATER = 0cm  in 0cm..5cm  "depth of the water"
param STONES = 3
param LABEL = +X
let x = [WATER, STONES, LABEL]
variant wet { WATER 2cm  STONES 2 * 4 }
variant turned { LABEL -Y }
)";

/// The value of `let x`, then the messages and hints of all errors.
std::string chosen_value(const std::string& text, const std::string& variant,
                         std::vector<Override> overrides = {}) {
  Diagnostics diagnostics;
  const Document document = parse(text, "t.vug", diagnostics);
  FakeResolver resolver;
  EvaluatorOptions options;
  options.variant = variant;
  options.overrides = std::move(overrides);
  Evaluator evaluator(document, resolver, diagnostics, options);
  std::string out;
  if (const Let* x = document.find_let("x"))
    out = to_string(evaluator.eval(*x->value, evaluator.root()));
  evaluator.check_all();
  evaluator.variants();
  for (const Diagnostic& one : diagnostics.all())
    out += "\n" + to_string(one.where) + ": " + one.message + " / " + one.hint;
  return out;
}

TEST(Variants, SetParameters) {
  EXPECT_EQ(chosen_value(kCave, ""), "[0m, 3, +X]");
  EXPECT_EQ(chosen_value(kCave, "wet"), "[0.02m, 8, +X]");
  EXPECT_EQ(chosen_value(kCave, "turned"), "[0m, 3, -Y]");
}

TEST(Variants, OverridesTakePrecedence) {
  EXPECT_EQ(chosen_value(kCave, "wet", {{"STONES", "5"}}), "[0.02m, 5, +X]");
}

TEST(Variants, ListTheirValues) {
  const Document document = parsed(kCave);
  FakeResolver resolver;
  Diagnostics diagnostics;
  Evaluator evaluator(document, resolver, diagnostics);
  const std::vector<VariantValues> all = evaluator.variants();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].variant->name, "wet");
  ASSERT_EQ(all[0].values.size(), 2u);
  EXPECT_EQ(all[0].values[0].first, "WATER");
  EXPECT_EQ(to_string(all[0].values[0].second), "0.02m");
}

TEST(Variants, FormattingKeepsThem) {
  const std::string once = format(kCave);
  EXPECT_EQ(format(once), once);
  EXPECT_EQ(dump(parsed(once)), dump(parsed(kCave)));
}

TEST(Variants, UnknownVariantsAreErrors) {
  EXPECT_EQ(chosen_value(kCave, "wett"),
            "[0m, 3, +X]\n--variant wett: the scene has no variant 'wett' / did you mean 'wet'? "
            "its variants: wet, turned");
  EXPECT_EQ(chosen_value("let x = 1", "wet"),
            "1\n--variant wet: the scene has no variant 'wet' / it declares no variants; add one "
            "with e.g. 'variant wet { WATER 2cm }', which sets 'param WATER'");
}

/// The error of a scene with one parameter and this variant, which is not chosen.
std::string fault(const std::string& variant, const std::string& chosen = "") {
  const std::string all =
      chosen_value("param SIZE = 1m in 10cm..2m\nlet x = SIZE\nvariant big " + variant, chosen);
  return all.substr(all.find('\n') + 1);
}

TEST(Variants, AreCheckedEvenIfTheyAreNotChosen) {
  EXPECT_EQ(fault("{ LENGTH 1m }"),
            "t.vug:3:15: variant 'big' sets 'LENGTH', but the scene has no such param / "
            "its params: SIZE");
  EXPECT_EQ(fault("{ SIZE 3m }"), "t.vug:3:20: param 'SIZE' is 3m, outside 0.1m..2m / ");
  EXPECT_EQ(fault("{ SIZE 30deg }"), "t.vug:3:20: param 'SIZE' is a length, not an angle / ");
  EXPECT_EQ(fault("{ SIZE 1m, 2m }"),
            "t.vug:3:15: variant 'big' gives 2 values to 'SIZE' / a param has one value; "
            "write a list as SIZE [ ... ]");
  EXPECT_EQ(fault("{ SIZE 1m  SIZE 2m }"),
            "t.vug:3:24: variant 'big' sets 'SIZE' twice / write each param once per variant");
  EXPECT_EQ(fault("{ SIZE 2 * SIZE }"), "t.vug:3:24: 'SIZE' depends on itself / SIZE -> SIZE");
}

TEST(Variants, ErrorsOfAChosenVariantAreReportedOnce) {
  EXPECT_EQ(fault("{ SIZE 3m }", "big"), "t.vug:3:20: param 'SIZE' is 3m, outside 0.1m..2m / ");
}

}  // namespace
}  // namespace vug::scene
