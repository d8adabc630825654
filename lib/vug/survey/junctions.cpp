// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/junctions.h>

#include <vug/base/error.h>

namespace vug::survey {
namespace {

/// The number of the first unknown of each point that chains end at and that is not fixed.
std::vector<Eigen::Index> number_unknowns(const LegGraph& graph,
                                          const std::vector<TraverseChain>& chains,
                                          Eigen::Index& size) {
  std::vector<Eigen::Index> unknown(static_cast<size_t>(graph.points), -1);
  for (const TraverseChain& chain : chains)
    for (const int point : {chain.from, chain.to}) {
      const size_t p = static_cast<size_t>(point);
      if (graph.positions[p] || unknown[p] >= 0) continue;
      unknown[p] = size;
      size += 3;
    }
  return unknown;
}

/// Adds a block of 3 by 3 with a sign to the triplets.
void add_block(std::vector<Eigen::Triplet<double>>& triplets, Eigen::Index row, Eigen::Index column,
               const Eigen::Matrix3d& block, double sign) {
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index j = 0; j < 3; ++j)
      triplets.emplace_back(static_cast<int>(row + i), static_cast<int>(column + j),
                            sign * block(i, j));
}

}  // namespace

JunctionSolver::JunctionSolver(LegGraph& graph, const std::vector<TraverseChain>& chains,
                               const std::vector<ChainSum>& sums)
    : unknown_(number_unknowns(graph, chains, size_)) {
  if (size_ == 0) return;
  // Coordinates relative to a fixed point keep their digits.
  Vec3d origin(0);
  for (const auto& position : graph.positions)
    if (position) {
      origin = *position;
      break;
    }
  std::vector<Eigen::Triplet<double>> triplets;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size_);
  for (size_t i = 0; i < chains.size(); ++i) {
    const TraverseChain& chain = chains[i];
    if (chain.from == chain.to) continue;
    const Eigen::Matrix3d weight = sums[i].covariance.inverse();
    const int ends[2] = {chain.from, chain.to};
    for (int end = 0; end < 2; ++end) {
      const Eigen::Index row = unknown_[static_cast<size_t>(ends[end])];
      if (row < 0) continue;
      const size_t other = static_cast<size_t>(ends[1 - end]);
      right.segment<3>(row) += (end == 1 ? 1 : -1) * weight * sums[i].vector;
      add_block(triplets, row, row, weight, 1);
      if (unknown_[other] >= 0)
        add_block(triplets, row, unknown_[other], weight, -1);
      else
        right.segment<3>(row) += weight * as_eigen(*graph.positions[other] - origin);
    }
  }
  Eigen::SparseMatrix<double> normal(size_, size_);
  normal.setFromTriplets(triplets.begin(), triplets.end());
  solver_.compute(normal);
  const Eigen::VectorXd solution = solver_.solve(right);
  if (solver_.info() != Eigen::Success || !solution.allFinite())
    throw Error(ErrorCode::bad_input, "the loops of the survey cannot be closed", {},
                "the standard deviations of some readings differ too much; check *sd and *fix");
  for (size_t p = 0; p < unknown_.size(); ++p)
    if (unknown_[p] >= 0)
      graph.positions[p] = origin + from_eigen(solution.segment<3>(unknown_[p]));
}

Eigen::Matrix3d JunctionSolver::covariance_between(const TraverseChain& chain) const {
  if (size_ == 0 || chain.from == chain.to) return Eigen::Matrix3d::Zero();
  Eigen::MatrixXd difference = Eigen::MatrixXd::Zero(size_, 3);
  const Eigen::Index from = unknown_[static_cast<size_t>(chain.from)],
                     to = unknown_[static_cast<size_t>(chain.to)];
  if (to >= 0) difference.block<3, 3>(to, 0) += Eigen::Matrix3d::Identity();
  if (from >= 0) difference.block<3, 3>(from, 0) -= Eigen::Matrix3d::Identity();
  return difference.transpose() * Eigen::MatrixXd(solver_.solve(difference));
}

}  // namespace vug::survey
