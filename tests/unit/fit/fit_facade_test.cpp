// SPDX-License-Identifier: Apache-2.0
// The complete pipeline from evidence to tree.
#include "enumeration.h"

#include <vug/base/error.h>
#include <vug/fit/fit_facade.h>
#include <vug/fit/model/compile.h>
#include <vug/fit/polish/polish.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace vug::fit {
namespace {

constexpr int kWallWidth = 96, kWallHeight = 80;

/// Four columns and three rows of windows of 12 x 14 pixels.
bool is_window(int x, int y) {
  return x % 24 >= 6 && x % 24 < 18 && y < 72 && y % 24 >= 5 && y % 24 < 19;
}

Evidence pixels(double noise, bool supervised) {
  RandomStream stream{RandomKey(4)};
  std::vector<uint32_t> values;
  for (int y = 0; y < kWallHeight; ++y)
    for (int x = 0; x < kWallWidth; ++x) {
      const bool odd = stream.uniform() < noise;
      const uint32_t seen = odd ? stream.below(4) : is_window(x, y) ? 1 : 0;
      for (uint32_t lane = 0; lane < kRegionTypes; ++lane)
        values.push_back(supervised ? (lane == seen ? 10 : 300) : (lane == seen ? 1 : 0));
    }
  return Evidence(kWallWidth, kWallHeight, kRegionTypes, values);
}

const Rules& rules() {
  static const Rules all = compile(facade::load_rules(VUG_DATA "/facades/ripperda.vug"));
  return all;
}

FitOptions quick(const std::string& likelihood) {
  FitOptions options;
  options.likelihood = likelihood;
  options.sampler.steps = 20'000;
  return options;
}

TEST(FitFacade, FindsWindowsWithEachLikelihood) {
  for (const LikelihoodKind* kind : likelihood_kinds()) {
    const FitResult found = fit_facade(pixels(0.2, kind->info.name == "supervised"), rules(),
                                       quick(kind->info.name), RandomKey(1));
    EXPECT_EQ(found.elements.size(), 12u) << kind->info.name;
    for (const DetectedElement& one : found.elements) {
      EXPECT_EQ(one.type, RegionType::window);
      EXPECT_NEAR(one.rect.x0 % 24, 6, 1);
      EXPECT_NEAR(one.rect.x1 % 24, 18, 1);
      EXPECT_NEAR(one.rect.y0 % 24, 5, 1);
      EXPECT_NEAR(one.rect.y1 % 24, 19, 1);
    }
    const Report& report = found.report;
    EXPECT_LE(report.bits, report.chain_bits);
    EXPECT_LE(report.chain_bits, report.seed_bits);
    EXPECT_LT(report.seed_bits, report.wall_bits);
    EXPECT_GT(report.complexity, 0);
    EXPECT_GT(report.score, 0);
    EXPECT_LT(report.score, 1);
  }
}

/// Perturbed trees are repaired if no number is off by more than a few pixels.
TEST(Polish, NeverIncreasesBitsAndRepairsTrees) {
  const Evidence evidence = pixels(0.2, false);
  const Model model(rules(), {}, kWallWidth, kWallHeight,
                    {&evidence, make_likelihood("kt", evidence)});
  const EdgeHints hints = EdgeHints::from_clusters(evidence);
  const MoveContext context{model, hints};
  RandomStream stream{RandomKey(12)};
  int same = 0;
  const std::vector<TreeState> found = seeds(context, evidence, false);
  TreeState best = found.front();
  polish(context, evidence, best);
  const double bits = model.energy(best);
  const inference::Moves<TreeState> some =
      moves(context, {"shift", "resize", "pitch", "line", "divide"});
  for (int trial = 0; trial < 50; ++trial) {
    inference::Chain<TreeState> chain(some, [&](TreeState& state) { return model.energy(state); },
                                      best, RandomKey(static_cast<uint64_t>(trial)),
                                      {.temperature = 300});
    for (int step = 0; step < 60; ++step) chain.step();
    TreeState spoilt = chain.state();
    const PolishResult done = polish(context, evidence, spoilt);
    EXPECT_EQ(done.before, chain.energy());
    EXPECT_LE(done.after, done.before);
    EXPECT_EQ(done.after, model.energy(spoilt));
    EXPECT_GE(done.rounds, 1);
    same += done.after <= bits + 1e-6 ? 1 : 0;
  }
  EXPECT_GE(same, 45);
}

TEST(FitFacade, ReportsImprovementsWithoutAffectingTheResult) {
  FitOptions options = quick("kt");
  const FitResult alone = fit_facade(pixels(0.2, false), rules(), options, RandomKey(1));
  options.runs = 1;
  std::vector<double> bits;
  options.sampler.improved = [&](const TreeState& best, double energy) {
    EXPECT_GT(best.tree.size(), 0);
    EXPECT_TRUE(bits.empty() || energy < bits.back());
    bits.push_back(energy);
  };
  const FitResult watched = fit_facade(pixels(0.2, false), rules(), options, RandomKey(1));
  ASSERT_FALSE(bits.empty());
  EXPECT_DOUBLE_EQ(bits.back(), watched.report.chain_bits);
  options.runs = 2;
  options.sampler.improved = [](const TreeState&, double) {};
  EXPECT_EQ(fit_facade(pixels(0.2, false), rules(), options, RandomKey(1)).tree, alone.tree);
}

TEST(FitFacade, CancelledRunReturnsTheBestSoFar) {
  Progress progress;
  progress.cancel();
  const FitResult found =
      fit_facade(pixels(0.2, false), rules(), quick("kt"), RandomKey(1), progress);
  EXPECT_TRUE(found.report.stopped);
  EXPECT_EQ(found.elements.size(), 12u) << "the seed";
}

TEST(FitFacade, UnsuitableEvidenceIsRejected) {
  EXPECT_THROW(fit_facade(pixels(0, false), rules(), quick("kl"), RandomKey(1)), Error);
  const Evidence two = Evidence::from_clusters(2, 1, 2, {0, 1});
  EXPECT_THROW(fit_facade(two, rules(), quick("supervised"), RandomKey(1)), Error);
}

/// The wall with a region of the type of doors, which is 12 x 40 pixels large, at the top.
Evidence pixels_with_door_in_the_sky() {
  std::vector<uint32_t> values;
  for (int y = 0; y < kWallHeight; ++y)
    for (int x = 0; x < kWallWidth; ++x) {
      const bool door = x >= 42 && x < 54 && y >= 4 && y < 44;
      const uint32_t seen = static_cast<uint32_t>(door              ? RegionType::door
                                                  : is_window(x, y) ? RegionType::window
                                                                    : RegionType::wall);
      for (uint32_t lane = 0; lane < kRegionTypes; ++lane)
        values.push_back(lane == seen ? 10 : 300);
    }
  return Evidence(kWallWidth, kWallHeight, kRegionTypes, values);
}

TEST(FitFacade, DoorsAreOnTheGroundAndNotTooHigh) {
  const auto doors = [](const Limits& limits) {
    FitOptions options = quick("supervised");
    options.sampler.steps = 5'000;
    options.limits = limits;
    std::vector<Rect> out;
    for (const DetectedElement& one :
         fit_facade(pixels_with_door_in_the_sky(), rules(), options, RandomKey(1)).elements)
      if (one.type == RegionType::door || one.type == RegionType::shop) out.push_back(one.rect);
    return out;
  };
  EXPECT_FALSE(doors({}).empty()) << "the evidence suggests one";
  Limits grounded;
  grounded.max_sill = 8;
  for (const Rect& door : doors(grounded)) EXPECT_GE(door.y1, kWallHeight - 8);
  grounded.max_door_height = 30;
  for (const Rect& door : doors(grounded)) EXPECT_LE(door.y1 - door.y0, 30);
}

/// A run whose energies and numbers of elements vary about these values.
SamplerResult run_about(double bits, double elements, uint64_t seed) {
  RandomStream stream{RandomKey(seed)};
  SamplerResult out;
  for (int round = 0; round < 400; ++round) {
    out.trace.push_back(bits + stream.normal());
    out.elements.push_back(elements + static_cast<double>(stream.below(2)));
  }
  return out;
}

TEST(Report, RunsThatDisagreeCauseAWarning) {
  const auto warning = [](const SamplerResult& a, const SamplerResult& b) {
    const Report report = make_report({a, b});
    const auto found = disagreement(report);
    EXPECT_EQ(nlohmann::json::parse(report_json(report))["warnings"].empty(), !found);
    EXPECT_EQ(report_svg(report).find("disagree") == std::string::npos, !found);
    return found ? found->message + "; " + found->hint : "";
  };
  EXPECT_EQ(warning(run_about(100, 20, 1), run_about(100, 20, 2)), "");
  const std::string bits = warning(run_about(100, 20, 1), run_about(106, 20, 2));
  EXPECT_NE(bits.find("R-hat 3."), std::string::npos) << bits;
  EXPECT_NE(bits.find("99.9 bits with 20.5 elements and 106.0 bits with 20.5 elements"),
            std::string::npos)
      << bits;
  EXPECT_NE(bits.find("--iterations"), std::string::npos) << bits;
  EXPECT_NE(bits.find("--looks"), std::string::npos) << bits;
  // Trees of equal length with different elements.
  EXPECT_NE(warning(run_about(100, 20, 1), run_about(100, 24, 2)), "");
  EXPECT_FALSE(disagreement(make_report({run_about(100, 20, 1)})));
}

TEST(FitFacade, ReportsDiagnostics) {
  FitOptions options = quick("kt");
  options.runs = 3;
  const Report report = fit_facade(pixels(0.3, false), rules(), options, RandomKey(1)).report;
  double shares = 0;
  for (const StructureProbability& one : report.posterior) {
    EXPECT_GE(one.standard_error, 0);
    EXPECT_LE(one.standard_error, 0.5);
    shares += one.probability;
  }
  EXPECT_NEAR(shares, 1, 0.05);
  EXPECT_EQ(report.traces.size(), 3u);
  EXPECT_LT(report.scale_reduction, 1.2) << "independent runs agree";
  EXPECT_GT(report.effective_size, 20);
  EXPECT_LT(std::abs(report.geweke), 5);
  EXPECT_EQ(report.swap_rates.size() + 1, report.temperatures.size());
  EXPECT_EQ(report.moves.size(), move_kinds().size());
  EXPECT_GT(report.max_complexity, report.complexity);
  EXPECT_NEAR(report.score,
              1 - (report.complexity + report.misfit) /
                      (report.max_complexity + 2.0 * kWallWidth * kWallHeight),
              1e-12);
  const nlohmann::json json = nlohmann::json::parse(report_json(report));
  EXPECT_EQ(json["posterior"].size(), report.posterior.size());
  EXPECT_EQ(json["traces"].size(), 3u);
  EXPECT_EQ(json["bits"]["all"].get<double>(), report.bits);
  const std::string drawing = report_svg(report);
  EXPECT_EQ(drawing.substr(0, 4), "<svg");
  EXPECT_EQ(drawing.find("nan"), std::string::npos);
  EXPECT_NE(drawing.find(report.moves.back().name), std::string::npos);
}

/// Pictures without content are walls.
TEST(FitFacade, OnePixelAndOneColour) {
  for (const int side : {1, 40}) {
    const Evidence plain = Evidence::from_clusters(
        side, side, 2, std::vector<uint8_t>(static_cast<size_t>(side * side), 1));
    const FitResult found = fit_facade(plain, rules(), quick("kt"), RandomKey(1));
    EXPECT_TRUE(found.elements.empty()) << side;
    EXPECT_EQ(found.tree.size(), 1) << side;
  }
}

}  // namespace
}  // namespace vug::fit
