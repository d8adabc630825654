// SPDX-License-Identifier: Apache-2.0
// Files that are included as modules, with prefixes and parameters.
#include <map>

#include "fake_resolver.h"
#include "parsing.h"

namespace vug::scene {
namespace {

/// The value of `let x`; errors as "! message".
std::string value_with(const std::map<std::string, std::string>& files, const std::string& text,
                       const std::vector<Override>& overrides = {},
                       const std::string& variant = {}) {
  ParseOptions parsing;
  parsing.read = [&](const std::filesystem::path& path) -> std::optional<std::string> {
    const auto file = files.find(path.generic_string());
    return file == files.end() ? std::nullopt : std::optional(file->second);
  };
  Diagnostics diagnostics;
  const Document document = parse(text, "t.vug", diagnostics, parsing);
  FakeResolver resolver;
  EvaluatorOptions options;
  options.overrides = overrides;
  options.variant = variant;
  Evaluator evaluator(document, resolver, diagnostics, options);
  evaluator.check_all();
  std::string out;
  if (const Let* x = document.find_let("x"))
    out = to_string(evaluator.eval(*x->value, evaluator.root().at("let").at("x")));
  for (const Diagnostic& one : diagnostics.all()) out += "! " + one.message;
  return out;
}

const std::map<std::string, std::string> kit = {
    {"kit.vug",
     "param size = 2m  in 1m..5m\nlet _half = size / 2\ndef f(a) = a + _half + g(0)\n"
     "def g(size) = size\nlet list = [for i in 0..2: i * size]\n"},
    {"outer.vug", "include \"kit.vug\" as inner { size own }\nlet own = 4m\nlet y = inner.f(1m)\n"},
    {"parts.vug", "include \"more.vug\"\nlet a = b + 1\n"},
    {"more.vug", "let b = 1\n"},
    {"draws.vug", "let d = 0..1\n"},
};

TEST(Module, NamesHaveThePrefix) {
  EXPECT_EQ(value_with(kit, "include \"kit.vug\" as k\nlet x = k.f(1m) + k.size\n"), "4m");
  EXPECT_EQ(value_with(kit, "let x = k.list[1]\ninclude \"kit.vug\" as k\n"), "2m");
  EXPECT_EQ(value_with(kit, "let size = 7\ninclude \"kit.vug\" as k\nlet x = [size, k.size]\n"),
            "[7, 2m]");
  EXPECT_EQ(value_with(kit, "include \"outer.vug\" as o\nlet x = [o.y, o.inner.size]\n"),
            "[3m, 4m]");
  EXPECT_EQ(value_with(kit, "include \"outer.vug\" as o\nlet x = o.inner.f(0m)\n"), "2m");
  EXPECT_EQ(value_with(kit, "include \"parts.vug\" as p\nlet x = p.a + p.b\n"), "3");
}

TEST(Module, FunctionsOfTheTextMayHaveTheNamesOfThoseOfModules) {
  const std::string wrapper = "include \"kit.vug\" as k\ndef f(a) = k.f(a) + k.g(size: 1m)\n";
  EXPECT_EQ(value_with(kit, wrapper + "let x = [f(1m), k.f(1m)]\n"), "[3m, 2m]");
}

TEST(Module, ParametersAreGivenByTheIncludeOrFromOutside) {
  const std::string two =
      "include \"kit.vug\" as a { size 3m }\ninclude \"kit.vug\" as b\nlet x = [a.f(0m), "
      "b.f(0m)]\n";
  EXPECT_EQ(value_with(kit, two), "[1.5m, 1m]");
  EXPECT_EQ(value_with(kit, two, {{"b.size", "5"}, {"a.size", "1m"}}), "[0.5m, 2.5m]");
  EXPECT_EQ(value_with(kit, "include \"kit.vug\" as a { size 9m }\nlet x = a.size\n"),
            "! param 'a.size' is 9m, outside 1m..5m");
}

TEST(Module, VariantsSetParametersOfModules) {
  const std::map<std::string, std::string> file = {
      {"m.vug", "param A = 2m\nvariant big { A 3m }\n"}};
  const std::string text = "include \"m.vug\" as k\nvariant wide { k.A 5m }\nlet x = k.A\n";
  EXPECT_EQ(value_with(file, text), "2m");
  EXPECT_EQ(value_with(file, text, {}, "wide"), "5m");
  EXPECT_EQ(value_with(file, text, {}, "k.big"), "3m");
}

TEST(Module, DoesNotSeeTheNamesOfTheScene) {
  const std::map<std::string, std::string> file = {{"m.vug", "def f() = outside + 1\n"}};
  EXPECT_EQ(value_with(file, "let outside = 1\ninclude \"m.vug\" as m\nlet x = m.f()\n"),
            "! unknown name 'outside', in the call of 'm.f' at t.vug:3:11");
}

TEST(Module, DrawsOfTwoModulesDiffer) {
  EXPECT_EQ(value_with(kit,
                       "include \"draws.vug\" as a\ninclude \"draws.vug\" as b\n"
                       "let x = a.d == b.d\n"),
            "false");
}

}  // namespace
}  // namespace vug::scene
