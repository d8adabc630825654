// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/program.h>
#include <vug/facade/split.h>
#include <vug/image/measure.h>
#include <vug/loading/catalogue.h>
#include <vug/loading/example.h>
#include <vug/loading/facade_binding.h>
#include <vug/loading/grammar_binding.h>
#include <vug/loading/reader.h>
#include <vug/mesh/format.h>
#include <vug/render/film/aov_table.h>
#include <vug/shot/lsystem_plan.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

namespace vug::loading {
namespace {

/// The AOVs as kinds without parameters.
const std::vector<KindInfo>& aov_kinds() {
  static const std::vector<KindInfo> all = [] {
    std::vector<KindInfo> kinds;
    for (const render::AovInfo& aov : render::aovs()) {
      const auto& channels = aov.channels;
      std::string doc = fmt::format(
          "{} {}", aov.doc,
          channels.size() == 1  ? "Channel " + channels[0]
          : channels.size() > 4 ? fmt::format("Channels {} to {}", channels[0], channels.back())
                                : fmt::format("Channels {}", fmt::join(channels, ", ")));
      if (aov.is_default) doc += ", written by default";
      if (!aov.set.empty()) doc += fmt::format("; \"{}\" requests all of them", aov.set);
      kinds.push_back({aov.name, "aov", doc + ".", "", {}});
    }
    return kinds;
  }();
  return all;
}

std::vector<const KindInfo*> all_kinds() {
  std::vector<const KindInfo*> kinds;
  for (const DeclarationKind* kind : declaration_kinds()) kinds.push_back(&kind->info);
  kinds.push_back(&grammar_info());
  kinds.push_back(&shot::lsystem_schema().info());
  kinds.push_back(&facade_info());
  for (const facade::SplitKind* split : facade::splits()) kinds.push_back(&split->info);
  for (const KindRegistry& registry : kind_registries())
    for (const RegisteredKind& kind : registry.kinds) kinds.push_back(kind.info);
  for (const KindInfo& aov : aov_kinds()) kinds.push_back(&aov);
  for (const image::Measure* measure : image::measures()) kinds.push_back(&measure->info);
  for (const mesh::Format* format : mesh::formats()) kinds.push_back(&format->info);
  for (const exchange::Format* format : exchange::formats()) kinds.push_back(&format->info);
  for (const exchange::Program* program : exchange::programs()) kinds.push_back(&program->info);
  return kinds;
}

}  // namespace

std::vector<const KindInfo*> find_kinds(const std::string& word) {
  std::vector<const KindInfo*> kinds = all_kinds();
  if (word.empty()) return kinds;
  const KindRegistry* registry = find_registry(word);
  const auto belongs = [&](const KindInfo* kind) {
    return kind->name == word || kind->category == word ||
           (registry && registry->find(kind->name) && registry->find(kind->name)->info == kind);
  };
  std::vector<const KindInfo*> kept;
  std::copy_if(kinds.begin(), kinds.end(), std::back_inserter(kept), belongs);
  return kept;
}

namespace {

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// Whether the text contains all words, each at the beginning of a word.
bool contains_words(const std::string& text, const std::vector<std::string>& words) {
  const auto is_start = [&](size_t at) {
    return at == 0 || !std::isalnum(static_cast<unsigned char>(text[at - 1]));
  };
  return std::all_of(words.begin(), words.end(), [&](const std::string& word) {
    size_t at = text.find(word);
    while (at != text.npos && !is_start(at)) at = text.find(word, at + 1);
    return at != text.npos;
  });
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream in(lower(text));
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

}  // namespace

std::vector<const KindInfo*> search_kinds(const std::string& text) {
  const std::vector<std::string> words = words_of(text);
  std::vector<const KindInfo*> named, described;
  if (words.empty()) return named;
  for (const KindInfo* kind : all_kinds()) {
    const std::string names = lower(
        fmt::format("{} {} {}", kind->name, kind->category, fmt::join(synonyms_of(*kind), " ; ")));
    std::string all = names + " " + lower(kind->doc);
    if (contains_words(names, words)) {
      named.push_back(kind);
      continue;
    }
    for (const ParamInfo& param : kind->params)
      all += lower(" " + param.name + " " + param.doc + " " +
                   fmt::format("{}", fmt::join(param.choices, " ")));
    if (contains_words(all, words)) described.push_back(kind);
  }
  named.insert(named.end(), described.begin(), described.end());
  return named;
}

std::vector<std::string> kind_words() {
  std::vector<std::string> words;
  for (const KindInfo* kind : all_kinds()) {
    words.push_back(kind->name);
    if (std::find(words.begin(), words.end(), kind->category) == words.end())
      words.push_back(kind->category);
  }
  for (const KindRegistry& registry : kind_registries()) words.push_back(registry.type);
  return words;
}

namespace {

/// A bound with its unit; whole numbers with all digits.
std::string bound_text(double bound, Dimension dimension) {
  return dimension == Dimension::none ? fmt::format("{}", bound) : quantity_text(bound, dimension);
}

/// The unit of the bounds of a parameter in JSON.
std::string bound_unit(Dimension dimension) {
  const std::string unit = unit_of(dimension);
  return unit.empty() || unit[0] == '/' ? "1" + unit : unit;
}

}  // namespace

std::string describe(const ParamInfo& param) {
  std::string text = param.type;
  if (param.dimension != Dimension::none) text += fmt::format(" ({})", to_string(param.dimension));
  if (!param.choices.empty()) text = fmt::format("one of {}", fmt::join(param.choices, ", "));
  if (std::isfinite(param.min))
    text += fmt::format(", {} {}", param.above_min ? "above" : "at least",
                        bound_text(param.min, param.dimension));
  if (std::isfinite(param.max))
    text += fmt::format(", at most {}", bound_text(param.max, param.dimension));
  if (param.required) return text + ", required";
  return param.fallback.empty() ? text + ", optional" : text + ", default " + param.fallback;
}

nlohmann::ordered_json catalogue_json(const std::vector<const KindInfo*>& kinds) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const KindInfo* kind : kinds) {
    nlohmann::ordered_json params = nlohmann::ordered_json::array();
    for (const ParamInfo& param : kind->params) {
      nlohmann::ordered_json p = {{"name", param.name}, {"type", param.type}, {"doc", param.doc}};
      if (param.dimension != Dimension::none) {
        p["dimension"] = to_string(param.dimension);
        p["unit"] = bound_unit(param.dimension);
      }
      if (param.required) p["required"] = true;
      if (!param.fallback.empty()) p["default"] = param.fallback;
      if (std::isfinite(param.min)) p[param.above_min ? "above" : "min"] = param.min;
      if (std::isfinite(param.max)) p["max"] = param.max;
      if (!param.choices.empty()) p["choices"] = param.choices;
      params.push_back(std::move(p));
    }
    nlohmann::ordered_json entry = {
        {"name", kind->name}, {"category", kind->category}, {"doc", kind->doc}};
    if (!kind->cite.empty()) entry["cite"] = kind->cite;
    if (const auto synonyms = synonyms_of(*kind); !synonyms.empty()) entry["synonyms"] = synonyms;
    entry["example"] = example_of(*kind);
    entry["params"] = std::move(params);
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace vug::loading
