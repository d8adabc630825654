// The relief of a bamboo's nodes, as a displacement of the swept tube along its radius: a sheath
// scar, above it the nodal ridge, and a groove in the internode above each branch (the paper's
// displacement mapping, luo2010bamboo section 2.2). All lengths are shares of the stem's radius at
// the node, so that one text fits stems of any size.
#pragma once

#include <vector>

namespace vug::flora {

struct NodeDisplacementOptions {
  double scar = 0.06;          ///< Height of the sheath scar, a thin sharp ring at the node.
  double scar_width = 0.07;    ///< From its crest to its foot, along the stem.
  double ridge = 0.05;         ///< Height of the nodal ridge.
  double ridge_width = 0.16;   ///< From its crest to its foot.
  double ridge_above = 0.24;   ///< From the scar's crest to the ridge's.
  double groove = 0.1;         ///< Depth of the groove above a branch.
  double groove_width = 0.7;   ///< Radians from its bed to its rim.
  double groove_length = 0.8;  ///< How far up it runs, a share of the internode.

  /// A sentence on what is no relief; empty where all is well.
  const char* fault() const;
  bool operator==(const NodeDisplacementOptions&) const = default;
};

/// (1 - x^2)^2 between -1 and 1, else 0: smooth, and nothing outside, so that bounds are true.
inline double bump(double x) {
  const double rest = 1 - x * x;
  return rest > 0 ? rest * rest : 0;
}
inline double bump_slope(double x) {
  const double rest = 1 - x * x;
  return rest > 0 ? -4 * x * rest : 0;
}
inline constexpr double kBumpSlope = 1.5396007178390021;  ///< Its greatest slope, 16 / sqrt(108).

/// A height and how it changes.
struct DisplacementSample {
  double height = 0;
  double along = 0;   ///< For a metre along the stem.
  double around = 0;  ///< For a radian around it.
};

/// A node as the relief needs it.
struct DisplacedNode {
  double along = 0;            ///< Metres along the stem.
  double radius = 0;           ///< Of the smooth stem there, times the node's size.
  double next = 0;             ///< Where the next node is, or the stem's end.
  std::vector<double> angles;  ///< Of branches, radians from the tube's normal.
};

/// What one stem's nodes displace. Immutable.
class NodeDisplacement {
 public:
  NodeDisplacement() = default;
  /// Nodes in the order of the stem.
  NodeDisplacement(const NodeDisplacementOptions& displacement, std::vector<DisplacedNode> nodes);

  /// Metres outwards of rings alone, the same all around.
  DisplacementSample rings(double along) const;
  /// 1 in the bed of a groove, 0 outside of grooves.
  DisplacementSample beds(double along, double angle) const;
  /// Metres inwards of the grooves.
  DisplacementSample grooves(double along, double angle) const;

  double highest() const { return highest_; }  ///< No ring is higher, metres.
  double deepest() const { return deepest_; }  ///< No groove is deeper.
  double slope() const { return slope_; }      ///< Most metres outwards for a metre along.
  double turn() const { return turn_; }        ///< Most metres inwards for a radian around.
  const std::vector<DisplacedNode>& nodes() const { return nodes_; }
  /// Where cross-sections should lie so that straight lines between them follow all rings.
  std::vector<double> rows() const;

 private:
  DisplacementSample ring_of(const DisplacedNode& node, double along) const;
  DisplacementSample groove_shape(const DisplacedNode& node, double along) const;
  const DisplacedNode* below(double along) const;  ///< The node whose internode it is; null: none.

  NodeDisplacementOptions displacement_;
  std::vector<DisplacedNode> nodes_;
  double highest_ = 0, deepest_ = 0, slope_ = 0, turn_ = 0;
};

}  // namespace vug::flora
