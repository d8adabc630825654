// The outline of a lanceolate leaf and the veins within, in coordinates of its own: what the mesh
// of a blade and the pictures on it share.
#pragma once

namespace vug::paint {

/// A place on a leaf.
struct LeafPoint {
  double across = 0;  ///< From -1 to 1 over the leaf's greatest width; 0 is the midrib.
  double along = 0;   ///< From 0 at the base to 1 at the tip.
};

/// The numbers that meshes of leaves carry at their vertices.
inline constexpr const char* kLeafAcross = "leaf_across";
inline constexpr const char* kLeafAlong = "leaf_along";

struct LeafOutline {
  double widest = 0.3;  ///< Share of the length where it is widest, between 0 and 1.
  double tip = 1.1;     ///< Above 0; the larger the longer and finer it tapers.

  /// Half of the width at `along`, of the greatest half: t^a (1 - t)^tip, a such that the most, 1,
  /// is at `widest`.
  double half_width(double along) const;
  bool contains(const LeafPoint& at) const;
};

struct LeafVeins {
  int count = 6;         ///< Of each half; they run along it and meet in the tip.
  double midrib = 0.06;  ///< Share of the width that the midrib takes.
  double cross_veins =
      40;  ///< Fine ones across, along its length: the chequers of bamboo. 0: none.
};

/// 1 on the midrib, 0.5 to 0 on veins and between; a smooth function of the place.
double vein_at(const LeafPoint& at, const LeafOutline& outline, const LeafVeins& veins);

}  // namespace vug::paint
