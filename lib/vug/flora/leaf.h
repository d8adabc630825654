// Leaves of bamboo as meshes: a lanceolate blade, folded along its midrib and bent by its weight,
// and sprays of them at the end of a twig.
#pragma once

#include <vug/base/rng.h>
#include <vug/mesh/mesh.h>
#include <vug/paint/leaf_pattern.h>

namespace vug::flora {

struct LeafOptions {
  double length = 0.11;  ///< Metres, from base to tip along the midrib; above 0.
  double width = 0.014;  ///< Metres, where it is widest, laid flat; above 0.
  paint::LeafOutline outline;
  double bend = 0.7;  ///< Radians that the tip points further down than the base.
  double fold = 0.3;  ///< Radians that each half stands up from the flat; the midrib lies lowest.
  double twist = 0;   ///< Radians about the midrib, from base to tip.
  int rows = 8;       ///< Pieces along its length, at least 2.
  /// A strip of the same width all along, for a material whose opacity cuts the outline out.
  bool card = false;

  std::string fault() const;  ///< A sentence on what does not fit; else empty.
};

/// The base in the origin, the midrib leaving along y, the upper face towards z: as the turtle
/// places things. An open mesh with unit normals that carries kLeafAcross and kLeafAlong.
/// Error(bad_input) with the fault.
mesh::Mesh leaf(const LeafOptions& options);

struct SprayOptions {
  LeafOptions leaf;
  int leaves = 4;         ///< At least 1; one at the end of the twig, the others in turn beside it.
  double angle = 0.7;     ///< Radians between twig and leaves beside it.
  double spacing = 0.02;  ///< Metres along the twig from leaf to leaf.
  double vary = 0.2;      ///< Lengths differ by up to that share, angles and bends alike.
  RandomKey key{0};
};

/// Leaves in two rows on a twig that begins in the origin and goes along y. Also carries "copy", a
/// random number from 0 to 1 for each leaf.
mesh::Mesh spray(const SprayOptions& options);

}  // namespace vug::flora
