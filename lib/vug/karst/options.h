// SPDX-License-Identifier: Apache-2.0
// The options of the karst generator. Weights are factors of cost per metre: a passage avoids a
// metre of unfavourable rock if the detour is shorter than 1 + weight metres.
#pragma once

#include <cstdint>

namespace vug::karst {

/// The points between which water can flow.
struct SampleOptions {
  int count = 5000;           ///< Number of samples.
  double on_beds = 0.5;       ///< Fraction on inception horizons.
  double on_fractures = 0.1;  ///< Fraction on joints and their crossings.
  /// Samples on joints are on joints of finite length with directions of their own, at their
  /// crossings and along them, and passages run along these joints.
  bool joint_network = false;
  double in_permeable = 0.1;  ///< Fraction in permeable balls and ghost rock.
  int neighbours = 24;        ///< Number of nearest samples to which a sample is joined.
  /// Metres between passages that do not meet. Samples keep kMeeting times it.
  double separation = 2;
};

struct CostOptions {
  double bed = 2;           ///< Weight of leaving the inception horizons.
  double bed_reach = 10;    ///< Metres from a horizon at which its effect ends.
  double fracture = 2;      ///< Weight of directions across joints.
  double permeability = 1;  ///< Weight of rock outside permeable parts.
  double ghost_rock = 2;    ///< Weight of rock outside ghost rock.
  double vadose = 3;        ///< Weight of rising, above the water table; horizontal flow is half.
  double phreatic = 2;      ///< Weight of leaving the water table, below it.
  double table_reach = 30;  ///< Metres from the water table at which its effect ends.
  double heterogeneity = 0.3;  ///< Standard deviation of the logarithm of a random factor.
  double shortness = 0.5;      ///< Exponent with which longer legs cost more per metre.
  double reuse = 0.4;          ///< Factor of the cost of passages that exist (cohesion), in 0..1.
};

struct GrowthOptions {
  int sinks = 8;      ///< Random sinks, if the geology has none.
  int waypoints = 0;  ///< Random points of the network, if the geology has no waypoints.
  /// Exponent of the gamma graph that joins sinks, springs and waypoints directly: 2 keeps few
  /// ways, values near 1 keep almost all. 0: water flows from sinks to springs only.
  double gamma = 0;
  int dead_ends = 60;            ///< Number of added passages that end blindly.
  double dead_end_length = 12;   ///< Median distance of their ends in metres.
  double dead_end_spread = 1.4;  ///< Standard deviation of the distance's logarithm.
  double loops = 0.08;           ///< Independent cycles for each junction or end.
  double loop_least = 30;        ///< Least distance between the ends of an added loop in metres.
  double loop_most = 150;        ///< Largest distance between the ends of an added loop in metres.
  double at_junctions = 0.06;    ///< Fraction of added passages that start at a junction.
  double clustering = 0.85;      ///< Fraction that starts near another added passage.
  double cluster_radius = 25;    ///< Largest distance in metres between such starts.
};

struct ShapeOptions {
  double leg_length = 8;       ///< Longest leg in metres.
  double wander = 0.1;         ///< Sideways displacement of the middle of a leg by its length.
  double zigzag = 0;           ///< Fraction of legs that follow joints in steps, in 0..1.
  double vadose_slope = 0.12;  ///< Slope of vadose passages between pitches, radians.
  double pitch = 12;           ///< Mean height of pitches in metres.
  double looping = 0.15;       ///< Depth of phreatic loops by the length of the leg.
};

struct KarstOptions {
  uint64_t seed = 1;
  SampleOptions samples{};
  CostOptions cost{};
  GrowthOptions growth{};
  ShapeOptions shape{};
};

/// Throws Error(bad_input) that names the first option out of its range.
void require_valid(const KarstOptions& options);

}  // namespace vug::karst
