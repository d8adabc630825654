// SPDX-License-Identifier: Apache-2.0
// A cellular network: points on surfaces with a common spacing, each linked to its neighbours
// [@gobron2006]. Rules (cells/rule.h) change the attributes of cells; positions and links are
// constant.
#pragma once

#include <vug/base/hash.h>
#include <vug/base/rng.h>
#include <vug/base/vec.h>
#include <vug/cells/links.h>

#include <memory>
#include <string>
#include <vector>

namespace vug::cells {

/// Number of cells that a parallel loop processes at once.
inline constexpr size_t kCellGrain = 4096;

/// Arrays with one element per cell, in an order that follows space: neighbours in space are close
/// in memory, whatever the order of the polygons.
struct Network {
  double spacing = 0;  ///< Cell size c_s: approximate distance between neighbours in metres.
  double reach = 0;    ///< Cells further apart on the surface (metres) are never linked, r_i.
  uint32_t full = 0;   ///< Links of a cell in a regular grid and maximum of all cells, l_g.
  std::vector<Vec3f> position;   ///< Metres, in world space.
  std::vector<Vec3f> normal;     ///< Unit length, out of the solid.
  std::vector<Vec3f> right;      ///< Unit length, tangent: see cells/frames.h.
  std::vector<float> area;       ///< Area of the surface represented by the cell, square metres.
  std::vector<uint32_t> object;  ///< Index of the object that the cell lies on.
  Links links;

  size_t size() const { return position.size(); }
  uint64_t bytes() const;  ///< Memory use.
  bool operator==(const Network&) const = default;
};

using NetworkPtr = std::shared_ptr<const Network>;

/// The tangent that completes a right-handed frame with `right` and the normal: right x ahead =
/// normal. On walls it points up.
inline Vec3f ahead(const Network& n, uint32_t cell) { return n.normal[cell].cross(n.right[cell]); }

/// A key for random choices derived from the cell's position, so it does not change when the
/// surface changes elsewhere.
uint64_t position_key(const Vec3f& position);

/// Connected components, numbered from 0 in order of their first cell; one number per cell.
std::vector<uint32_t> components(const Links& links);

Digest digest(const Network& network);

/// Throws Error(internal) with the fault unless arrays have the same length, every number is
/// finite, normals and frames are orthonormal up to 1e-4, and links are mutual, sorted, without
/// self-links, and at most `full` per cell.
void validate(const Network& network);

/// A flat sheet (y up) of `across` by `along` cells with periodic boundaries, the classic domain of
/// cellular automata. `full` is 3 (honeycomb, both numbers even), 4, 6 (`along` even) or 8. Cell
/// (x, z) has the index z * across + x. At least 4 by 4 cells.
Network flat_torus(uint32_t across, uint32_t along, uint32_t full, double spacing = 1);

}  // namespace vug::cells
