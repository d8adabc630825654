// SPDX-License-Identifier: Apache-2.0
// The measures by which collon2017karst compares karst networks, in the form of 2021. A value is
// NaN where it is undefined, for example the tortuosity of a network that consists of loops.
#pragma once

#include <vug/network/network.h>

namespace vug::network {

struct Metrics {
  int stations = 0;    ///< With at least one leg.
  int legs = 0;        ///< Without surface legs, duplicates and repeated legs.
  int components = 0;  ///< Connected parts.
  int cycles = 0;      ///< Independent cycles: legs - stations + components.
  int nodes = 0;       ///< Nodes of Reduction::graph.
  int edges = 0;       ///< Edges of Reduction::graph.
  double length = 0;   ///< Metres of all legs.

  /// H_O, the entropy of the azimuths of all legs in 18 bins of 10 degrees (0 to 180), weighted by
  /// the horizontal length: 0 for parallel legs, 1 for legs in all directions.
  double orientation_entropy = 0;
  double branch_length = 0;     ///< Mean length of a branch in metres.
  double length_entropy = 0;    ///< H_len, of branch lengths in 10 bins from 0 to the longest.
  double length_variation = 0;  ///< CV_len, standard deviation (N - 1) by the mean.
  double tortuosity = 0;        ///< t, mean of length by distance of the ends; loops do not count.

  double degree = 0;              ///< k, of the reduced graph; see mean_degree.
  double degree_variation = 0;    ///< CV_k.
  double degree_correlation = 0;  ///< r_k.
  double path_length = 0;         ///< SPL, in edges.
  double dominance = 0;           ///< CPD.
};

/// Throws like require_valid.
Metrics measure(const Network& network);

/// The azimuth in radians of a scene-space vector: 0 is north (-z), pi/2 east (+x), in [0, pi)
/// after folding opposite directions together; NaN for a vertical vector.
double folded_azimuth(const Vec3d& vector);

}  // namespace vug::network
