// SPDX-License-Identifier: Apache-2.0
// Bamboo leaves as meshes: a lanceolate blade, folded along its midrib and bent by its weight, and
// sprays of leaves at the end of a twig.
#pragma once

#include <vug/base/rng.h>
#include <vug/mesh/mesh.h>
#include <vug/paint/leaf_pattern.h>

namespace vug::flora {

struct LeafOptions {
  double length = 0.11;  ///< Metres from base to tip along the midrib; above 0.
  double width = 0.014;  ///< Metres at the widest point, laid flat; above 0.
  paint::LeafOutline outline;
  double bend = 0.7;  ///< Radians by which the tip points further down than the base.
  double fold = 0.3;  ///< Radians by which each half rises from the flat; the midrib is lowest.
  double twist = 0;   ///< Radians about the midrib, from base to tip.
  int rows = 8;       ///< Segments along its length, at least 2.
  /// Makes a strip of constant width for a material whose opacity cuts out the outline.
  bool card = false;

  std::string fault() const;  ///< The first invalid combination as a sentence; empty if valid.
};

/// The base is at the origin, the midrib leaves along y and the upper face points to z, the
/// convention of the turtle. An open mesh with unit normals and the attributes kLeafAcross and
/// kLeafAlong. Error(bad_input) with the fault.
mesh::Mesh leaf(const LeafOptions& options);

struct SprayOptions {
  LeafOptions leaf;
  /// At least 1; one at the end of the twig, the others alternating along it.
  int leaves = 4;
  double angle = 0.7;     ///< Radians between the twig and its lateral leaves.
  double spacing = 0.02;  ///< Metres along the twig from leaf to leaf.
  double vary = 0.2;      ///< Relative variation of lengths, angles and bends.
  RandomKey key{0};
};

/// Leaves in two rows on a twig that starts at the origin along y. Adds the attribute "copy", a
/// random number from 0 to 1 per leaf.
mesh::Mesh spray(const SprayOptions& options);

}  // namespace vug::flora
