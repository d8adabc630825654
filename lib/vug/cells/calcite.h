// SPDX-License-Identifier: Apache-2.0
// Calcite that films of water deposit or dissolve (dreybrodt1980, kaufmann2003).
#pragma once

#include <vug/cells/film_flow.h>

namespace vug::cells {

struct CalciteOptions {
  double equilibrium = 0;   ///< Concentration at which nothing is deposited, mol/m3.
  double rate = 0;          ///< Flux per excess of concentration in water at rest, m/s.
  double agitation = 5e-3;  ///< Speed of the film that doubles the rate, m/s.
};

/// All in mol/s: what enters with the water equals what is deposited plus what leaves with it.
struct CalciumBalance {
  double supplied = 0, deposited = 0, drained = 0;
};

struct CalciteRates {
  std::vector<double> deposit;       ///< For each cell, mol/s; negative where rock dissolves.
  std::vector<Load> load;            ///< What arrives at each cell; see Drainage::route.
  std::vector<float> concentration;  ///< Calcium in the water that leaves a cell, mol/m3; 0 if dry.
  CalciumBalance balance;
};

/// The rates for the surface as it is now. Of the excess of calcium over the equilibrium, a film
/// that crosses a cell keeps exp(-k A / Q), with the wetted area A, the discharge Q and the rate
/// k = rate (1 + x / (1 + x / 9)), x = speed / agitation. A pool is well mixed above a layer
/// through which calcium diffuses: 1 / k = 1 / rate + depth / diffusivity. Cells that the pass does
/// not update deposit nothing. The attribute `hardness`, 0 to 1, slows dissolution.
CalciteRates calcite_rates(Pass& pass, const FilmFlow& flow, const CalciteOptions& options);

/// The area of the surface displaced by `height` relative to that of the network: 1 where it is
/// level, sqrt(1 + slope^2) elsewhere, at most 3.
std::vector<float> stretch(const Pass& pass);

/// Spreads what neighbouring wet cells of the pass deposit: `share` of the difference of their
/// rates per area is exchanged in each of `rounds`; the sum is conserved.
void smooth_deposit(const Pass& pass, double share, int rounds, CalciteRates& rates);

}  // namespace vug::cells
