// Whether a chain has run long enough, by one number of each of its states.
#pragma once

#include <vector>

namespace vug::inference {

/// A number of a chain's states, in order: the energy, or a count of windows.
using Trace = std::vector<double>;

/// Steps after which a chain has forgotten where it was: the sum of autocorrelations up to the
/// first window of five times itself (cite sokal1997); at least 1.
double autocorrelation_time(const Trace& trace);
/// How many independent values the trace is worth.
double effective_size(const Trace& trace);
/// Gelman and Rubin's potential scale reduction of traces that are each cut in halves (cite
/// gelman2013); near 1 when they tell of the same distribution. Traces have the same length, at
/// least 4; 1 where nothing varies at all.
double scale_reduction(const std::vector<Trace>& traces);

/// Geweke's z-score (cite geweke1992): how many standard errors the means of the first tenth and of
/// the second half of the trace are apart; beyond 2 it had not warmed up. 0 where nothing varies.
double geweke(const Trace& trace);

}  // namespace vug::inference
