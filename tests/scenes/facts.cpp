// SPDX-License-Identifier: Apache-2.0
#include "facts.h"

#include <vug/base/atomic_file.h>
#include <vug/shot/lsystem_plan.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace vug::session {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path kScenes = fs::path(VUG_DATA) / "scenes";

json facts_of(const metrics::Report& report) {
  const Box3d& b = report.bounds;
  return {{"components", report.components},
          {"genus", report.genus ? json(*report.genus) : json()},
          {"area", report.area},
          {"volume", report.volume},
          {"bounds", {{b.min.x, b.min.y, b.min.z}, {b.max.x, b.max.y, b.max.z}}}};
}

/// Whether a value equals the expected number or lies in the expected range [min, max].
bool count_fits(const json& measured, const json& wanted) {
  if (!wanted.is_array()) return measured == wanted;
  return !measured.is_null() && measured >= wanted.at(0) && measured <= wanted.at(1);
}

}  // namespace

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(kScenes))
    if (entry.path().extension() == ".vug")
      names.push_back(fs::relative(entry.path(), kScenes).generic_string());
  std::sort(names.begin(), names.end());
  return names;
}

loading::Loaded load_scene(const std::string& name, const std::vector<scene::Override>& overrides,
                           std::optional<uint64_t> seed) {
  loading::LoadOptions options;
  options.overrides = overrides;
  options.seed = seed;
  options.include_folders = {VUG_DATA};
  loading::Loaded loaded = loading::load(kScenes / name, options);
  EXPECT_TRUE(loaded.usable()) << loaded.report();
  return loaded;
}

const json& scene_facts() {
  static const json facts = json::parse(read_text(fs::path(VUG_TEST_DATA) / "scene_facts.json"));
  return facts;
}

void expect_facts(const metrics::Report& report, const json& facts) {
  const json measured = facts_of(report);
  const double share = facts.value("tolerance", 0.01);
  const double size = report.bounds.size().length();
  EXPECT_TRUE(count_fits(measured.at("components"), facts.at("components"))) << measured;
  EXPECT_TRUE(count_fits(measured.at("genus"), facts.at("genus"))) << measured;
  for (const char* key : {"area", "volume"}) {
    const double wanted = facts.at(key);
    EXPECT_NEAR(measured.at(key).get<double>(), wanted, share * std::fabs(wanted))
        << key << ' ' << measured;
  }
  for (const size_t end : {0U, 1U})
    for (const size_t axis : {0U, 1U, 2U})
      EXPECT_NEAR(measured.at("bounds").at(end).at(axis).get<double>(),
                  facts.at("bounds").at(end).at(axis).get<double>(), share * size)
          << measured;
}

void expect_words(const shot::Shot& shot, const json& facts) {
  const json wanted = facts.value("words", json::object());
  for (const auto& item : wanted.items()) {
    const std::string& name = item.key();
    const json& known = item.value();
    SCOPED_TRACE(name);
    const auto plan =
        std::find_if(shot.lsystems.begin(), shot.lsystems.end(),
                     [&](const shot::LSystemPtr& each) { return each->name == name; });
    ASSERT_NE(plan, shot.lsystems.end()) << "the scene has no such L-system";
    const lsystem::System& system = *(*plan)->system;
    lsystem::Derivation derivation = (*plan)->derive();
    const lsystem::Word word = known.value("drawn", false)
                                   ? lsystem::interpret(system, std::move(derivation))
                                   : std::move(derivation.word);
    EXPECT_EQ(word.size(), known.at("modules").get<size_t>());
    std::map<std::string, size_t> counts;
    for (const lsystem::SymbolId symbol : word.symbols()) ++counts[system.alphabet.name(symbol)];
    for (const auto& [symbol, count] : known.at("symbols").items())
      EXPECT_EQ(counts[symbol], count.get<size_t>()) << symbol;
  }
}

void expect_attributes(const mesh::Mesh& mesh, const json& facts) {
  const json wanted = facts.value("attributes", json::object());
  for (const auto& [name, range] : wanted.items()) {
    const mesh::Attribute* attribute = mesh::find_attribute(mesh, name);
    ASSERT_TRUE(attribute) << name;
    double sum = 0;
    for (const float value : attribute->values) sum += static_cast<double>(value);
    const double mean = sum / static_cast<double>(attribute->values.size());
    EXPECT_GE(mean, range.at(0).get<double>()) << name;
    EXPECT_LE(mean, range.at(1).get<double>()) << name;
  }
}

}  // namespace vug::session
