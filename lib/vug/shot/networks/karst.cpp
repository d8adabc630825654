// SPDX-License-Identifier: Apache-2.0
// A network that water cuts into the rock.
#include <vug/karst/presets.h>
#include <vug/karst/realistic.h>
#include <vug/shot/geology.h>
#include <vug/shot/networks.h>
#include <vug/shot/section_choice.h>

namespace vug::shot {
namespace {

std::vector<std::pair<std::string, std::string>> preset_names() {
  std::vector<std::pair<std::string, std::string>> names;
  for (const karst::Preset& preset : karst::presets()) names.emplace_back(preset.name, preset.name);
  return names;
}

struct Karst : SectionChoice {
  std::string preset = "branchwork";
  int seed = 1;
  std::optional<Vec3d> from, to;
  std::optional<field::Field> rock;
  std::vector<GeologyFeaturePtr> geology;
  std::optional<int> samples, sinks, waypoints, dead_ends, attempts;
  std::optional<double> loops, gamma, cohesion, heterogeneity;
  std::optional<double> leg_length, wander, zigzag, vadose_slope, pitch, looping;

  static void describe(Schema<Karst>& s) {
    const auto count = [](std::string doc, double most) {
      return ParamSpec{.doc = std::move(doc), .min = 0, .max = most};
    };
    const auto least_length = [](std::string doc) {
      return ParamSpec{.doc = std::move(doc), .dimension = Dimension::length, .min = 0.1};
    };
    s.doc(
         "The network that water cuts from sinks to springs, along beds and joints, first down to "
         "the water table and then along it. A preset provides everything; features of the geology "
         "replace those of the same kind in the preset.")
        .cite("paris2021karst")
        .choice("preset", &Karst::preset, preset_names(), "the pattern of the cave")
        .param("seed", &Karst::seed, {.doc = "selects another cave", .min = 0})
        .param("from", &Karst::from, any_length("the lowest corner of the rock"))
        .param("to", &Karst::to, any_length("the highest corner of the rock"))
        .param("rock", &Karst::rock, {.doc = "the rock that the cave stays in"})
        .param("geology", &Karst::geology, {.doc = "beds, fractures, water tables, sinks, ..."})
        .param("samples", &Karst::samples,
               {.doc = "number of points between which water can flow", .min = 10, .max = 2e5})
        .param("sinks", &Karst::sinks, count("number of random sinks, if none is given", 1000))
        .param("waypoints", &Karst::waypoints,
               count("number of random points of the network", 1000))
        .param("dead_ends", &Karst::dead_ends, count("number of blind passages", 10000))
        .param("loops", &Karst::loops,
               {.doc = "loops for each junction or end", .min = 0, .max = 1})
        .param("gamma", &Karst::gamma,
               {.doc = "exponent of the graph that joins sinks, springs and waypoints directly: 2 "
                       "keeps few ways, values near 1 almost all, 0 only those to springs",
                .min = 0,
                .max = 10})
        .param("cohesion", &Karst::cohesion,
               {.doc = "how strongly water prefers passages that exist: 0 not at all, 1 as if they "
                       "cost nothing",
                .min = 0,
                .max = 1})
        .param("heterogeneity", &Karst::heterogeneity,
               {.doc = "standard deviation of the logarithm of the rock's random resistance",
                .min = 0,
                .max = 3})
        .param("leg_length", &Karst::leg_length, least_length("the longest leg"))
        .param("wander", &Karst::wander,
               {.doc = "sideways displacement of the middle of a passage by its length",
                .min = 0,
                .max = 0.5})
        .param("zigzag", &Karst::zigzag,
               {.doc = "share of the passages that follow joints in steps", .min = 0, .max = 1})
        .param("vadose_slope", &Karst::vadose_slope,
               {.doc = "slope of passages above the water table, between pitches",
                .dimension = Dimension::angle,
                .min = 0,
                .max = 1.5})
        .param("pitch", &Karst::pitch, least_length("mean height of vertical pitches"))
        .param("looping", &Karst::looping,
               {.doc = "depth of the loops below the water table by the length of a passage",
                .min = 0,
                .max = 2})
        .param("attempts", &Karst::attempts,
               {.doc = "caves that are tried until the measures of one lie within those of real "
                       "caves; 8 for a preset without changes, else 1",
                .min = 1,
                .max = karst::kMostAttempts});
    SectionChoice::describe(s);
  }

  std::string fault() const {
    return from.has_value() == to.has_value() ? "" : "'from' and 'to' are needed together";
  }
};

/// Whether the text leaves the preset as it is, apart from the seed.
bool is_plain(const Karst& p) {
  return p.geology.empty() && !p.from && !p.rock && !p.samples && !p.sinks && !p.waypoints &&
         !p.dead_ends && !p.loops && !p.gamma && !p.cohesion && !p.heterogeneity && !p.leg_length &&
         !p.wander && !p.zigzag && !p.vadose_slope && !p.pitch && !p.looping;
}

/// The preset's geology, with the given features in place of those of the same kind.
karst::Geology geology_of(const Karst& p, karst::Geology preset) {
  karst::Geology own;
  for (const GeologyFeaturePtr& feature : p.geology) (*feature)(own);
  const auto replace = [](auto& usual, auto& given) {
    if (!given.empty()) usual = std::move(given);
  };
  replace(preset.beds, own.beds);
  replace(preset.fractures, own.fractures);
  replace(preset.faults, own.faults);
  replace(preset.permeable, own.permeable);
  replace(preset.ghost_rock, own.ghost_rock);
  replace(preset.water_tables, own.water_tables);
  replace(preset.sinks, own.sinks);
  replace(preset.springs, own.springs);
  replace(preset.entrances, own.entrances);
  replace(preset.waypoints, own.waypoints);
  if (p.rock) preset.solid = p.rock;
  if (p.from) preset.bounds = {*p.from, *p.to};
  return preset;
}

NetworkPtr grow(const Karst& p) {
  const karst::Preset& preset = karst::find_preset(p.preset);
  karst::KarstOptions options = preset.options;
  options.seed = static_cast<uint64_t>(p.seed);
  const auto set = [](auto& option, const auto& given) { option = given.value_or(option); };
  set(options.samples.count, p.samples);
  set(options.growth.sinks, p.sinks);
  set(options.growth.waypoints, p.waypoints);
  set(options.growth.dead_ends, p.dead_ends);
  set(options.growth.loops, p.loops);
  set(options.growth.gamma, p.gamma);
  set(options.cost.heterogeneity, p.heterogeneity);
  if (p.cohesion) options.cost.reuse = 1 - *p.cohesion;
  set(options.shape.leg_length, p.leg_length);
  set(options.shape.wander, p.wander);
  set(options.shape.zigzag, p.zigzag);
  set(options.shape.vadose_slope, p.vadose_slope);
  set(options.shape.pitch, p.pitch);
  set(options.shape.looping, p.looping);
  const int attempts = p.attempts.value_or(is_plain(p) ? 8 : 1);
  return std::make_shared<const network::Network>(network::draw_sections(
      karst::generate_realistic(geology_of(p, preset.geology), options, attempts).network,
      p.model(), options.seed));
}

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_KIND(karst) { return make_kind<NetworkPtr, Karst>("karst", "network", grow); }
