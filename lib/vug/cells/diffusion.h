// SPDX-License-Identifier: Apache-2.0
// Parameters and number of iterations for the diffusion of moisture in one step.
#pragma once

#include <vug/base/schema.h>

#include <algorithm>
#include <cmath>

namespace vug::cells {

struct DiffusionSteps {
  int rounds = 1;
  double share = 0;  ///< Fraction of a cell's moisture that one iteration gives to its neighbours,
                     ///< at most 0.8.

  /// `creep`: distance in metres that moisture spreads in a step, sqrt(4 D). A fraction a
  /// corresponds to D = a c^2 / 4.
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
          positive_length("distance that moisture spreads in a step, up to 7 spacings"))
      .param("from", &P::from, {.doc = "the attribute that wets rock"})
      .param("full", &P::full,
             {.doc = "value of that attribute at which rock is saturated",
              .min = 0,
              .above_min = true});
}

}  // namespace vug::cells
