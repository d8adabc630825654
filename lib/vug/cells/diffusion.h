// How moisture creeps through rock in one step: rounds of explicit diffusion, each stable.
#pragma once

#include <vug/base/schema.h>

#include <algorithm>
#include <cmath>

namespace vug::cells {

struct DiffusionSteps {
  int rounds = 1;
  double share = 0;  ///< Of what a cell has that a round gives to its neighbours, 0.8 at most.

  /// `creep`: metres that moisture spreads in a step, sqrt(4 D). A share a moves as D = a c^2 / 4.
  DiffusionSteps(double creep, double spacing) {
    constexpr double kMost = 0.8;
    constexpr int kRounds = 64;
    const double all = creep * creep / (spacing * spacing);
    rounds = static_cast<int>(std::clamp(std::ceil(all / kMost), 1.0, double{kRounds}));
    share = std::min(all / rounds, kMost);
  }
};

template <class P>
void describe_diffusion(Schema<P>& s) {
  s.param("creep", &P::creep,
          positive_length("way that moisture spreads in a step, up to 7 spacings"))
      .param("from", &P::from, {.doc = "the attribute that wets rock"})
      .param("full", &P::full,
             {.doc = "value of that attribute with which rock is as wet as can be",
              .min = 0,
              .above_min = true});
}

}  // namespace vug::cells
