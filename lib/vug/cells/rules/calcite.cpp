// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/cells/calcite.h>
#include <vug/cells/diffusion.h>
#include <vug/cells/rule.h>
#include <vug/drips/chemistry.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::cells {
namespace {

/// The growth after which the flow is computed again, in spacings, and the number of these times
/// in a step.
constexpr double kGrowth = 0.05;
constexpr int kMostFlows = 100;

struct Calcite : FilmParams {
  double years = 1;
  std::optional<double> calcium;
  std::optional<double> equilibrium;
  double agitation = 5e-3;
  double smooth = 0;

  static void describe(Schema<Calcite>& s) {
    s.doc(
         "Films of water deposit calcite, or dissolve rock where they contain less calcium than "
         "in equilibrium with the air. The faster a film runs, the faster it deposits, so crests "
         "grow, pools form behind them, and slopes become terraces. Provides calcite (thickness), "
         "calcium (mol/m3), height, and film, pool, discharge and outlet as `film` does.")
        .cite("dreybrodt1980")
        .cite("hammer2007");
    describe_film(s);
    s.param("years", &Calcite::years,
            {.doc = "duration of a step in years", .min = 0, .above_min = true})
        .param("calcium", &Calcite::calcium,
               {.doc = "calcium of the water that enters, in mol/m3; default: that of water from "
                       "below soil at the temperature",
                .min = 0})
        .param("equilibrium", &Calcite::equilibrium,
               {.doc = "calcium in equilibrium with the air, in mol/m3; default: that of a cave",
                .min = 0})
        .param("agitation", &Calcite::agitation,
               positive_length("distance per second of a film that deposits twice as fast as "
                               "water at rest"))
        .param("smooth", &Calcite::smooth,
               {.doc = "distance over which deposits spread, up to 7 spacings",
                .dimension = Dimension::length,
                .min = 0});
  }

  void step(Pass& pass) const {
    const double seeping = calcium.value_or(drips::seep_calcium(temperature));
    CalciteOptions options;
    options.equilibrium = equilibrium.value_or(drips::equilibrium_calcium(temperature));
    options.rate = drips::deposition_rate(temperature);
    options.agitation = agitation;
    const DiffusionSteps spread(smooth, pass.network().spacing);
    double left = years * drips::kSecondsPerYear;
    for (int flows = 0; left > 0; ++flows) {
      if (flows == kMostFlows && !pass.is_trial()) throw too_long(pass.network().spacing);
      const FilmFlow flow(pass, *this, seeping);
      CalciteRates rates = calcite_rates(pass, flow, options);
      if (smooth > 0) smooth_deposit(pass, spread.share, spread.rounds, rates);
      left -= grow(pass, flow, rates, pass.is_trial() ? 0 : left);
      if (pass.is_trial()) break;
    }
  }

 private:
  static double grow(Pass& pass, const FilmFlow& flow, const CalciteRates& rates, double left) {
    const Network& n = pass.network();
    const auto speed = [&](size_t i) {  // Metres per second.
      return n.area[i] > 0
                 ? drips::kCalciteVolume * rates.deposit[i] / static_cast<double>(n.area[i])
                 : 0.0;
    };
    const double fastest = ordered_reduce(
        n.size(), 0.0, [&](size_t i) { return std::fabs(speed(i)); },
        [](double a, double b) { return std::max(a, b); });
    const double time = fastest > 0 ? std::min(left, kGrowth * n.spacing / fastest) : left;
    const auto height = pass.writes<float>("height"), calcite = pass.writes<float>("calcite"),
               concentration = pass.writes<float>("calcium");
    pass.run([&](const auto&, uint32_t i) {
      const auto grown = static_cast<float>(speed(i) * time);
      height.set(i, height[i] + grown);
      calcite.set(i, calcite[i] + grown);
      concentration.set(i, rates.concentration[i]);
    });
    write_film(pass, flow, rates.load);
    return time;
  }

  Error too_long(double spacing) const {
    return Error(ErrorCode::bad_input,
                 fmt::format("in a step of {:.3g} years more than {:.2g} m of calcite would grow",
                             years, kMostFlows * kGrowth * spacing),
                 {}, "use fewer 'years' and more 'steps'");
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(calcite) { return rule_kind<Calcite>("calcite"); }
