// SPDX-License-Identifier: Apache-2.0
// Internal to adjust: the search for readings that explain the misclosure of a traverse.
#pragma once

#include <vug/survey/covariance_matrix.h>

namespace vug::survey {

/// A misclosure, the covariance of the measured traverse, and that of the misclosure.
struct ClosureTest {
  Eigen::Vector3d misclosure;
  Eigen::Matrix3d measured;
  Eigen::Matrix3d residual;
};

/// The readings of a traverse whose normalised residual exceeds three standard deviations, the
/// largest first, at most five. For each reading, the test assumes that it is the only wrong one
/// ("data snooping" [@baarda1968]).
std::vector<Blunder> find_blunders(const LegGraph& graph, const Observations& observations,
                                   const TraverseChain& chain, const ClosureTest& test);

}  // namespace vug::survey
