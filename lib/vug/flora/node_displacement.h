// SPDX-License-Identifier: Apache-2.0
// Radial displacement of a swept tube at the nodes of bamboo: a sheath scar, the nodal ridge above
// it, and a groove in the internode above each branch (displacement mapping of luo2010bamboo,
// section 2.2). All lengths are relative to the stem's radius at the node, so that one set of
// values fits stems of any size.
#pragma once

#include <vug/base/digester.h>

#include <vector>

namespace vug::flora {

struct NodeDisplacementOptions {
  double scar = 0.06;          ///< Height of the sheath scar, a thin sharp ring at the node.
  double scar_width = 0.07;    ///< From its crest to its foot, along the stem.
  double ridge = 0.05;         ///< Height of the nodal ridge.
  double ridge_width = 0.16;   ///< From its crest to its foot.
  double ridge_above = 0.24;   ///< From the crest of the scar to the crest of the ridge.
  double groove = 0.1;         ///< Depth of the groove above a branch.
  double groove_width = 0.7;   ///< Radians from its bed to its rim.
  double groove_length = 0.8;  ///< Length upwards as a share of the internode.

  /// The first invalid value as a sentence; empty if valid.
  const char* fault() const;
  bool operator==(const NodeDisplacementOptions&) const = default;
};

/// (1 - x^2)^2 between -1 and 1, else 0: smooth with compact support, which keeps bounds valid.
inline double bump(double x) {
  const double rest = 1 - x * x;
  return rest > 0 ? rest * rest : 0;
}
inline double bump_slope(double x) {
  const double rest = 1 - x * x;
  return rest > 0 ? -4 * x * rest : 0;
}
/// Maximum slope of bump(), 16 / sqrt(108).
inline constexpr double kBumpSlope = 1.5396007178390021;

/// A displacement and its derivatives.
struct DisplacementSample {
  double height = 0;
  double along = 0;   ///< Derivative per metre along the stem.
  double around = 0;  ///< Derivative per radian around the stem.
};

/// A node as the displacement sees it.
struct DisplacedNode {
  double along = 0;            ///< Metres along the stem.
  double radius = 0;           ///< Radius of the smooth stem at the node, times the node's size.
  double next = 0;             ///< Position of the next node, or of the stem's end.
  std::vector<double> angles;  ///< Directions of branches, radians from the tube's normal.
};

/// The displacement by the nodes of one stem. Immutable.
class NodeDisplacement {
 public:
  NodeDisplacement() = default;
  /// The nodes are in order along the stem.
  NodeDisplacement(const NodeDisplacementOptions& displacement, std::vector<DisplacedNode> nodes);

  /// Outward displacement of the rings in metres, rotationally symmetric.
  DisplacementSample rings(double along) const;
  /// Groove profile: 1 in the bed, 0 outside of grooves.
  DisplacementSample beds(double along, double angle) const;
  /// Depth of the grooves in metres, inwards.
  DisplacementSample grooves(double along, double angle) const;

  double highest() const { return highest_; }  ///< Upper bound of the rings, metres.
  double deepest() const { return deepest_; }  ///< Upper bound of the grooves, metres.
  double slope() const { return slope_; }      ///< Maximum outward slope per metre along the stem.
  /// Maximum inward slope in metres per radian around the stem.
  double max_angular_slope() const { return max_angular_slope_; }
  const std::vector<DisplacedNode>& nodes() const { return nodes_; }
  /// Positions of cross-sections that resolve all rings with straight lines between them.
  std::vector<double> rows() const;

  void add_to(Digester& digester) const { digester(displacement_, nodes_); }

 private:
  DisplacementSample ring_of(const DisplacedNode& node, double along) const;
  DisplacementSample groove_shape(const DisplacedNode& node, double along) const;
  /// The node below, whose internode it is; null: none.
  const DisplacedNode* below(double along) const;

  NodeDisplacementOptions displacement_;
  std::vector<DisplacedNode> nodes_;
  double highest_ = 0, deepest_ = 0, slope_ = 0, max_angular_slope_ = 0;
};

}  // namespace vug::flora
