// SPDX-License-Identifier: Apache-2.0
// The choice of different shots among many good ones.
#pragma once

#include <vug/scout/candidates.h>

#include <map>
#include <vector>

namespace vug::scout {

/// A candidate with its score and what it shows.
struct Rated {
  Candidate candidate;
  double score = 0;
  std::map<uint32_t, double> shares;  ///< Share of the picture for each visible object.
};

/// The shares of the objects in a view.
std::map<uint32_t, double> object_shares(const View& view);

/// 0 to 1: exp(-(distance / 8 m)^2 - (difference of the azimuths / 40 degrees)^2), times the
/// overlap of the shares, the sum of their minima.
double similarity(const Rated& a, const Rated& b);

/// The indices of up to `wanted` shots, best first: each next one has the largest score, relative
/// to the best, minus 0.7 times its greatest similarity to those before it. Afterwards two wide,
/// two low and two close shots and one upwards take the last places, if the chosen ones lack them
/// and candidates have at least half of the best score. The result depends on the order of `all`
/// only where scores are equal.
std::vector<size_t> choose_shots(const std::vector<Rated>& all, size_t wanted);

}  // namespace vug::scout
