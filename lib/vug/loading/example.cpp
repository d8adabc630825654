// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/example.h>
#include <vug/loading/kind_registry.h>

#include <fmt/format.h>
#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

namespace vug::loading {
namespace {

/// The statement around the expression of a kind, which replaces "@", by category.
const std::map<std::string, std::string>& statements() {
  static const std::string field = "field shape = @";
  static const std::map<std::string, std::string> all = {
      {"primitive", field},
      {"operator", field},
      {"deformer", field},
      {"detail", field},
      {"plant", field},
      {"blend", "field shape = union([sphere(1m), box(size: (1.5, 1.5, 1.5))], blend: @)"},
      {"noise", "field shape = displace(rock, noise: @, amount: 10cm)"},
      {"volume", "volume grid = @"},
      {"mask",
       "mesh painted on cave {\n"
       "  paint layer(under: (0.5, 0.45, 0.4), over: (0.1, 0.2, 0.05), mask: @)\n}"},
      {"paint", "mesh painted on cave { paint @ }"},
      {"material", "material stone = @"},
      {"light", "light lamp = @"},
      {"medium", "medium air = @"},
      {"camera", "camera main = @"},
      {"sampler", "render main { sampler @ }"},
      {"integrator", "render main { integrator @ }"},
      {"places", "place stones { of pebble at @ }"},
      {"model", "place stones { of @ at (4, 0, 0) }"},
      {"grid", "cells patch on skin { spacing 5cm  grid @  run moss(seeds: 5) }"},
      {"rule", "cells patch on skin { spacing 5cm  run @ }"},
      {"distribution",
       "place plants {\n  of pebble\n"
       "  at grove(polygon: [(0, 0), (9, 0), (9, 9)], count: 20, distribution: @)\n}"},
      {"shape", "mesh leaves { of @ }"},
      {"curve", "grammar stem: lsystem {\n  guides @\n  axiom F(1m)\n}"},
      {"network", "network cave_plan = @"},
      {"drips", "drips water = @"},
      {"drip edit", "drips water = seepage(rock, edits: [@])"},
      {"passage", field},
      {"section", "field air = passages(of: plan, section: @)"},
      {"section rule", "field air = passages(of: plan, sections: [@])"},
      {"label", "mesh walls on cave { labels [@] }"},
      {"labels", "mesh walls on cave { labels @ }"},
      {"dicing", "object walls on skin { detail @ }"},
      {"geology", "network cave_plan = karst(geology: [@])"},
      {"point", "camera main { eye @ }"},
      {"points", "light lamp[p in @] = sphere(center: p, radius: 2cm)"},
      {"element", "grammar house: facade {\n  axiom Front\n  Front -> @\n}"},
      {"split", "grammar house: facade {\n  axiom Front\n  Front -> @\n}"},
      {"aov", "render main { layers [\"beauty\", \"@\"] }"},
      {"measure", "vug diff reference.exr test.exr --metric @"},
      {"mesh format", "mesh copy on cave { format @ }"},
      {"exchange format", "vug export cave.vug --format @ -o out"},
      {"program", "vug export cave.vug --for @ -o out"},
  };
  return all;
}

/// The text of a required parameter by its type.
std::string argument_text(const ParamInfo& param) {
  if (param.dimension == Dimension::angle) return "30deg";
  if (param.dimension == Dimension::length && param.type == "number") return "10cm";
  static const std::map<std::string, std::string> texts = {
      {"field", "rock"},
      {"list of field", "[rock, sphere(1m)]"},
      {"lsystem", "fern"},
      {"mesh", "skin"},
      {"network", "plan"},
      {"drips", "roof"},
      {"mask", "slope(from: 50deg, to: 20deg)"},
      {"list of mask", "[slope(from: 50deg, to: 20deg), 0.5]"},
      {"paint", "(0.4, 0.35, 0.3)"},
      {"material", "lambert()"},
      {"number", "1"},
      {"text", "\"wetness\""},
  };
  const auto text = texts.find(param.type);
  return text == texts.end() ? "\"...\"" : text->second;
}

/// The kind with its required parameters.
std::string call_text(const KindInfo& kind) {
  std::string arguments;
  for (const ParamInfo& param : kind.params)
    if (param.required)
      arguments +=
          fmt::format("{}{}: {}", arguments.empty() ? "" : ", ", param.name, argument_text(param));
  static const std::set<std::string> names = {"blend",       "aov",     "measure",
                                              "mesh format", "program", "exchange format"};
  return names.count(kind.category) && arguments.empty()
             ? kind.name
             : fmt::format("{}({})", kind.name, arguments);
}

}  // namespace

namespace {

constexpr std::string_view kSynonyms = "# synonyms: ";

/// The text of the kind's file; empty if it has none. A stage of cells has the info of its rule
/// with more parameters.
std::string text_of(const KindInfo& kind) {
  for (const KindText& each : kind_texts())
    if (each.kind->name == kind.name && each.kind->category == kind.category) return each.text;
  return "";
}

}  // namespace

std::vector<std::string> synonyms_of(const KindInfo& kind) {
  const std::string text = text_of(kind);
  if (text.rfind(kSynonyms, 0) != 0) return {};
  std::vector<std::string> words;
  const std::string line = text.substr(kSynonyms.size(), text.find('\n') - kSynonyms.size());
  for (size_t at = 0; at < line.size();) {
    const size_t end = std::min(line.find(", ", at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end + 2;
  }
  return words;
}

bool is_synonym(const std::string& word, const KindInfo& kind) {
  const std::vector<std::string> words = synonyms_of(kind);
  return std::any_of(words.begin(), words.end(), [&](const std::string& each) {
    return boost::algorithm::iequals(word, each);
  });
}

std::string example_of(const KindInfo& kind) {
  std::string text = text_of(kind);
  if (text.rfind(kSynonyms, 0) == 0) text.erase(0, text.find('\n') + 1);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  if (!text.empty()) return text;
  if (const KindRegistry* registry = find_registry(kind.name);
      registry && kind.category == "declaration") {
    const RegisteredKind* usual = registry->find(kind.params.front().fallback);
    return example_of(usual ? *usual->info : *registry->kinds.front().info);
  }
  std::string expression = call_text(kind);
  if (const size_t at = expression.find("NAME"); at != std::string::npos)  // of a family of AOVs
    expression.replace(at, 4, kind.name == "attribute_NAME" ? "wetness" : "key");
  const auto statement = statements().find(kind.category);
  if (statement == statements().end()) return expression;
  text = statement->second;
  return text.replace(text.find('@'), 1, expression);
}

std::string example_scene() {
  return "field rock = difference(box(size: (6, 6, 6)), [sphere(2m)])\n"
         "volume cave = level_set(rock, voxel: 20cm)\n"
         "mesh skin on cave {}\n"
         "object chamber on skin {}\n"
         "volume grain = level_set(sphere(20cm), voxel: 5cm)\n"
         "mesh grain_mesh on grain {}\n"
         "object pebble on grain_mesh {}\n"
         "grammar fern: lsystem {\n  instances leaf\n  axiom F(1m) leaf(1) F(50cm)\n}\n"
         "grammar front: facade {\n  axiom Front\n"
         "  Front -> repeat(x, 2m, window)\n}\n"
         "volume wall = level_set(front, voxel: 20cm)\nmesh house on wall { elements front }\n"
         "network plan = graph(names: [\"mouth\", \"fork\", \"hall\", \"sump\"], "
         "at: [(0, 0, 0), (8, -1, 2), (15, -2, 0), (14, -4, 9)], "
         "paths: [\"mouth fork hall\", \"fork sump\"])\n"
         "drips roof = seepage(rock, from: (-3, -2, -3), to: (3, 2, 3))\n"
         "light panel = rect(center: (0, 1, 0), normal: (0, -1, 0), group: \"key\")\n";
}

}  // namespace vug::loading
