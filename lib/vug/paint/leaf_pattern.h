// SPDX-License-Identifier: Apache-2.0
// Outline and veins of a lanceolate leaf in leaf coordinates, shared by leaf meshes and leaf
// pictures.
#pragma once

namespace vug::paint {

/// Leaf coordinates of a point.
struct LeafPoint {
  double across = 0;  ///< From -1 to 1 over the leaf's greatest width; 0 is the midrib.
  double along = 0;   ///< From 0 at the base to 1 at the tip.
};

/// Vertex attributes of leaf meshes.
inline constexpr const char* kLeafAcross = "leaf_across";
inline constexpr const char* kLeafAlong = "leaf_along";

struct LeafOutline {
  double widest = 0.3;  ///< Fraction of the length where it is widest, between 0 and 1.
  double tip = 1.1;     ///< Above 0; the larger, the longer and finer the tip.

  /// Half width at `along`, relative to the greatest half width: t^a (1 - t)^tip, with a such that
  /// the maximum, 1, is at `widest`.
  double half_width(double along) const;
  bool contains(const LeafPoint& at) const;
};

struct LeafVeins {
  int count = 6;            ///< Veins of each half; they run lengthwise and meet at the tip.
  double midrib = 0.06;     ///< Fraction of the width that the midrib takes.
  double cross_veins = 40;  ///< Fine cross veins along the length, the chequers of bamboo. 0: none.
};

/// 1 on the midrib, up to 0.5 on veins, 0 between them; a smooth function of the point.
double vein_at(const LeafPoint& at, const LeafOutline& outline, const LeafVeins& veins);

}  // namespace vug::paint
