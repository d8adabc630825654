// SPDX-License-Identifier: Apache-2.0
// Internal to adjust: the normal equations of the junctions.
#pragma once

#include <vug/survey/covariance_matrix.h>

#include <Eigen/SparseCholesky>

namespace vug::survey {

/// Solves for the positions of all junctions that are not fixed.
class JunctionSolver {
 public:
  /// Sets the positions of junctions in `graph`. Error(bad_input) if the deviations are too
  /// different in size for a solution.
  JunctionSolver(LegGraph& graph, const std::vector<TraverseChain>& chains,
                 const std::vector<ChainSum>& sums);

  /// The covariance of the adjusted vector between the ends of a chain.
  Eigen::Matrix3d covariance_between(const TraverseChain& chain) const;

 private:
  Eigen::Index size_ = 0;              ///< Number of unknowns.
  std::vector<Eigen::Index> unknown_;  ///< For each point: the first of its three unknowns, or -1.
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

}  // namespace vug::survey
