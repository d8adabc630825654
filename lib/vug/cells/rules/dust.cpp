// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/cells/flow.h>
#include <vug/cells/rule.h>

#include <algorithm>
#include <cmath>

namespace vug::cells {
namespace {

/// A sandpile model: of two neighbours the higher gives dust to the lower while the slope between
/// their surfaces, including dust, exceeds the slope of repose.
struct Dust {
  double fall = 5e-5;
  double repose = 35 * kPi / 180;
  double shelter = 0;
  double speed = 0.05;

  static void describe(Schema<Dust>& s) {
    s.doc(
         "Dust settles on upward surfaces, slides off steep ones and falls from overhangs. "
         "Provides dust (thickness), height (which grows by it) and fallen.")
        .cite("hsu1995dust")
        .param("fall", &Dust::fall,
               {.doc = "thickness that settles on level rock per step",
                .dimension = Dimension::length,
                .min = 0})
        .param("repose", &Dust::repose,
               {.doc = "steepest slope on which dust rests",
                .dimension = Dimension::angle,
                .min = 0,
                .max = 80 * kPi / 180})
        .param("shelter", &Dust::shelter,
               {.doc = "reduction of the deposit in open places (exposure): 0 none, 100% complete",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1})
        .param("speed", &Dust::speed, positive_length("distance that dust slides per step"));
  }

  void step(Pass& pass) const {
    const Network& network = pass.network();
    deposit(pass, network);
    const int turns =
        std::max(pass.step() == 0 ? 1 : 0, moves_in_step(speed, network.spacing, pass.step()));
    for (int turn = 0; turn < turns; ++turn) slide(pass, network);
  }

 private:
  /// Metres by which a surface at `from` is above the resting height next to one at `to`; 0 if it
  /// is not.
  struct Excess {
    AttributeReader<Vec3f> position;
    std::vector<float> top;  ///< Heights of the surface including dust.
    float slope;
    float operator()(uint32_t from, uint32_t to) const {
      const float drop = top[from] - top[to];
      if (!(drop > 0)) return 0;
      const Vec3f offset = position[to] - position[from];
      const float reach2 = slope * slope * (offset.x * offset.x + offset.z * offset.z);
      return drop * drop > reach2 ? drop - std::sqrt(reach2) : 0;
    }
  };

  void deposit(Pass& pass, const Network& network) const {
    const auto dust = pass.writes<float>("dust"), height = pass.writes<float>("height");
    const OptionalReader open =
        shelter > 0 ? pass.reads_expected("exposure", 1) : OptionalReader{nullptr, 0};
    const auto most = static_cast<float>(fall), kept_off = static_cast<float>(shelter);
    pass.run([=, normal = network.normal.data()](const auto&, uint32_t i) {
      const float up = std::max(0.0f, normal[i].y);
      const float more = most * up * std::max(0.0f, 1 - kept_off * open[i]);
      dust.set(i, dust[i] + more);
      height.set(i, height[i] + more);
    });
  }

  void slide(Pass& pass, const Network& network) const {
    const auto dust = pass.writes<float>("dust"), height = pass.writes<float>("height");
    const auto fallen = pass.writes<float>("fallen");
    const AttributeReader<CellState> state = pass.states();
    Excess excess{pass.positions(), std::vector<float>(network.size()),
                  static_cast<float>(maths::tan(repose))};
    const auto each_cell = [&](const auto& body) {
      parallel_for(
          network.size(), [&](size_t i) { body(static_cast<uint32_t>(i)); }, 4096);
    };
    each_cell([&](uint32_t i) {
      excess.top[i] = excess.position[i].y + height[i] * std::max(0.0f, network.normal[i].y);
    });
    // For each cell, the amount that leaves per metre of excess.
    std::vector<float> gives(network.size());
    each_cell([&](uint32_t i) {
      if (!(dust[i] > 0) || state[i] != CellState::active) return;
      float sum = 0, most = 0;
      for (const uint32_t to : network.links.of(i)) {
        const float over = receives(state[to]) ? excess(i, to) : 0;
        sum += over;
        most = std::max(most, over);
      }
      gives[i] = sum > 0 ? std::min(dust[i], most / 2) / sum : 0;
    });
    pass.run([&](const auto&, uint32_t i) {
      float change = 0;
      for (const uint32_t n : network.links.of(i)) {
        if (gives[i] > 0 && receives(state[n])) change -= gives[i] * excess(i, n);
        if (gives[n] > 0) change += gives[n] * excess(n, i);
      }
      const bool hangs = network.normal[i].y <= 0;
      const float lies = std::max(0.0f, dust[i] + change), falls = hangs ? lies : 0;
      dust.set(i, lies - falls);
      fallen.set(i, fallen[i] + falls);
      height.set(i, height[i] + (lies - falls - dust[i]));
    });
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(dust) { return rule_kind<Dust>("dust"); }
