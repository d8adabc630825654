// SPDX-License-Identifier: Apache-2.0
// Convergence diagnostics of Markov chains, based on one scalar per state.
#pragma once

#include <vector>

namespace vug::inference {

/// One scalar per state of a chain, in order, e.g. the energy or the number of windows.
using Trace = std::vector<double>;

/// Integrated autocorrelation time in steps: the sum of autocorrelations up to the first window of
/// five times itself (cite sokal1997); at least 1.
double autocorrelation_time(const Trace& trace);
/// Effective sample size: the number of independent samples with the same information.
double effective_size(const Trace& trace);
/// Gelman and Rubin's potential scale reduction factor (split R-hat) of traces that are each split
/// in halves (cite gelman2013); near 1 if they sample the same distribution. All traces have the
/// same length, at least 4. Returns 1 if the values are constant.
double scale_reduction(const std::vector<Trace>& traces);

/// Geweke's z-score (cite geweke1992): the difference between the means of the first tenth and the
/// second half of the trace in standard errors; above 2 the chain had not burnt in. Returns 0 if
/// the values are constant.
double geweke(const Trace& trace);

}  // namespace vug::inference
