// SPDX-License-Identifier: Apache-2.0
// Internal to adjust: vectors and covariances as matrices of Eigen.
#pragma once

#include <vug/survey/leg_graph.h>
#include <vug/survey/traverses.h>

#include <Eigen/Dense>

namespace vug::survey {

inline Eigen::Vector3d as_eigen(const Vec3d& v) { return {v.x, v.y, v.z}; }
inline Vec3d from_eigen(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

inline Eigen::Matrix3d as_eigen(const Covariance& v) {
  Eigen::Matrix3d m;
  m << v.xx, v.xy, v.zx, v.xy, v.yy, v.yz, v.zx, v.yz, v.zz;
  return m;
}

/// The sums over the edges of a chain.
struct ChainSum {
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();

  ChainSum(const LegGraph& graph, const TraverseChain& chain) {
    for (size_t i = 0; i < chain.edges.size(); ++i) {
      const Edge& edge = graph.edges[static_cast<size_t>(chain.edges[i])];
      vector += (chain.forwards[i] ? 1 : -1) * as_eigen(edge.vector);
      covariance += as_eigen(edge.covariance);
    }
  }
};

}  // namespace vug::survey
