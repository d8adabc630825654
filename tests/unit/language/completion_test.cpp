// SPDX-License-Identifier: Apache-2.0
// Completion and signature help by the expected type.
#include "texts.h"

#include <gtest/gtest.h>
#include <vug/language/completion.h>
#include <vug/language/kinds.h>
#include <vug/language/signature.h>

#include <set>

namespace vug::language {
namespace {

std::set<std::string> labels(const std::string& marked,
                             std::optional<CompletionKind> kind = std::nullopt) {
  const MarkedText text(marked);
  std::set<std::string> all;
  for (const Completion& each : complete(text.workspace, *text.analysis, text.position).items)
    if (!kind || each.kind == *kind) all.insert(each.label);
  return all;
}

/// Whether all of the words are among the labels, and none of the others.
testing::AssertionResult has(const std::set<std::string>& labels,
                             const std::vector<std::string>& words,
                             const std::vector<std::string>& others = {}) {
  for (const std::string& word : words)
    if (!labels.count(word)) return testing::AssertionFailure() << "'" << word << "' is missing";
  for (const std::string& word : others)
    if (labels.count(word)) return testing::AssertionFailure() << "'" << word << "' is offered";
  return testing::AssertionSuccess();
}

/// The text after the completion of that label.
std::string completed(const std::string& marked, const std::string& label) {
  const MarkedText text(marked);
  const Completions all = complete(text.workspace, *text.analysis, text.position);
  for (const Completion& each : all.items)
    if (each.label == label) return apply(text.text, {{all.range, each.label}});
  return "none";
}

TEST(Completion, AnEmptyArgumentOffersExactlyTheMissingParameters) {
  // For each kind of one type, with none, one and all of its parameters given.
  for (const CallableKind& kind : callable_kinds()) {
    if (kind.type != "field" || callable_kinds(kind.info->name).size() != 1) continue;
    std::set<std::string> names;
    for (const ParamInfo& param : kind.info->params) names.insert(param.name);
    EXPECT_EQ(labels("let a = " + kind.info->name + "(|)\n", CompletionKind::argument), names);
    if (names.empty()) continue;
    const std::string given = *names.begin();
    names.erase(given);
    const std::string call = "let a = " + kind.info->name + "(" + given + ": 1, ";
    EXPECT_EQ(labels(call + "|)\n", CompletionKind::argument), names) << kind.info->name;
    EXPECT_EQ(labels(call + "|\nlet b = 2\n", CompletionKind::argument), names);
    EXPECT_EQ(
        labels("let a = " + kind.info->name + "(|, " + given + ": 1)\n", CompletionKind::argument),
        names);
  }
}

TEST(Completion, ABlockOffersTheEntriesThatItLacks) {
  const auto keys = labels("camera main { eye (0, 0, 3)  | }\n", CompletionKind::argument);
  EXPECT_TRUE(has(keys, {"target", "fov", "kind"}, {"eye"}));
  const auto flat =
      labels("camera main {\n  kind orthographic\n  |\n}\n", CompletionKind::argument);
  EXPECT_TRUE(has(flat, {"eye", "target"}, {"fov", "kind"}));
}

TEST(Completion, AStatementBeginsWithAKeyword) {
  for (const char* text :
       {"|", "let a = 1\n|", "let a = 1\nmes|", "mesh m on v {}\n|\nlet b = 2\n"})
    EXPECT_TRUE(has(labels(text), {"param", "let", "include", "volume", "camera"})) << text;
}

TEST(Completion, ValuesHaveTheExpectedType) {
  EXPECT_TRUE(has(labels("light key = |\n"), {"rect", "sphere", "sky"}, {"torus"}));
  EXPECT_TRUE(has(labels("volume v = level_set(|\n"), {"torus", "sphere", "union"}, {"rect"}));
  EXPECT_TRUE(has(labels("let a = 2cm\nlet b = sphere(radius: |)\n"), {"a", "sqrt"}, {"b"}));
  EXPECT_TRUE(has(labels("mesh m on |\nvolume v = level_set(sphere(1m), voxel: 1cm)\n"), {"v"}));
}

TEST(Completion, ChoicesUnitsAndModules) {
  EXPECT_TRUE(has(labels("camera c { kind | }\n"), {"perspective", "orthographic"}));
  EXPECT_TRUE(has(labels("let a = sphere(radius: 3|)\n", CompletionKind::unit), {"cm", "m", "mm"},
                  {"deg"}));
  EXPECT_EQ(completed("let a = sphere(radius: 3c|)\n", "cm"), "let a = sphere(radius: 3cm)\n");
  EXPECT_TRUE(has(labels("include \"kit/stains.vug\" as shore { | }\n"), {"level"}));
  EXPECT_TRUE(has(labels("include \"kit/stains.vug\" as shore\nlet a = shore.|\n"), {"pool_rim"}));
  EXPECT_TRUE(has(labels("include \"|\"\n", CompletionKind::file), {"kit/stains.vug"}));
  EXPECT_TRUE(has(labels("let a = sphere(1m).|\n"), {"translate", "warp"}));
}

TEST(Completion, RulesOfferSymbolsAndLocalNames) {
  const std::string grammar = "grammar g {\n  axiom Room\n  Room -> + sphere(1m) Hall(2)\n";
  EXPECT_TRUE(
      has(labels(grammar + "  Hall(n) -> |\n}\n", CompletionKind::symbol), {"Room", "Hall"}));
  EXPECT_TRUE(has(labels(grammar + "  Hall(n) if | -> nothing\n}\n"), {"n"}));
  EXPECT_TRUE(has(labels("def f(width) = 2 * |\n"), {"width"}));
  EXPECT_TRUE(has(labels("let a = [for item in [1, 2]: |]\n"), {"item"}));
  EXPECT_TRUE(has(labels("grammar g: |\n"), {"shape", "facade", "lsystem"}));
}

TEST(Completion, NothingInCommentsTextsAndNewNames) {
  for (const char* text : {"# a sph|\n", "let a = \"sph|\"\n", "let sph|\n", "def f(wid|\n"})
    EXPECT_TRUE(labels(text).empty()) << text;
}

TEST(Completion, AnUnclosedStatementDoesNotChangeTheNextOne) {
  EXPECT_TRUE(has(labels("let a = union([sphere(1m,\nlight key = |\n"), {"rect", "sky"}));
}

TEST(Signature, TheActiveParameterIsThatOfThePosition) {
  const auto active = [](const std::string& marked) {
    const MarkedText text(marked);
    const auto all = signatures_at(*text.analysis, text.position);
    if (all.empty() || all[0].active < 0) return std::string("none");
    const auto& one = all[0].parameters[static_cast<size_t>(all[0].active)];
    return all[0].label.substr(one.begin, one.end - one.begin);
  };
  EXPECT_EQ(active("let a = torus(|)\n").substr(0, 7), "[radius");
  EXPECT_EQ(active("def f(size, turn = 1) = size\nlet a = f(1, |\n"), "[turn]");
  EXPECT_EQ(active("def f(size, turn = 1) = size\nlet a = f(turn: |\n"), "[turn]");
  EXPECT_NE(active("let a = sphere(1m).translate(|)\n"), "none");
  EXPECT_EQ(active("let a = 1 + |\n"), "none");
}

}  // namespace
}  // namespace vug::language
