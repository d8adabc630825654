// A cellular network: points of one size on surfaces, each linked to its neighbours [@gobron2006].
// Rules (cells/rule.h) rewrite what the cells carry; where they are and their links stay.
#pragma once

#include <vug/base/hash.h>
#include <vug/base/rng.h>
#include <vug/base/vec.h>
#include <vug/cells/links.h>

#include <memory>
#include <string>
#include <vector>

namespace vug::cells {

/// Arrays with one element for each cell, in an order that follows space: neighbours in space are
/// near in memory, whatever the order of the polygons they lie on.
struct Network {
  double spacing = 0;  ///< Size of a cell, c_s: metres from one to the next, about.
  double reach = 0;    ///< Metres over the surface beyond which cells are never linked, r_i.
  uint32_t full = 0;   ///< Links of a cell amid a perfect grid, l_g; none has more.
  std::vector<Vec3f> position;   ///< Metres, in world space.
  std::vector<Vec3f> normal;     ///< Unit length, out of the solid.
  std::vector<Vec3f> right;      ///< Unit length, tangent: see cells/frames.h.
  std::vector<float> area;       ///< Square metres of the surface that the cell stands for.
  std::vector<uint32_t> object;  ///< Which of the objects the cell lies on.
  Links links;

  size_t size() const { return position.size(); }
  uint64_t bytes() const;  ///< That it holds.
  bool operator==(const Network&) const = default;
};

using NetworkPtr = std::shared_ptr<const Network>;

/// Tangent that with `right` and the normal makes a right-handed frame: right x ahead = normal.
/// On walls it points up.
inline Vec3f ahead(const Network& n, uint32_t cell) { return n.normal[cell].cross(n.right[cell]); }

/// A number of the cell's place, for keys of random choices: it does not change when the surface
/// changes elsewhere.
uint64_t position_key(const Vec3f& position);

/// Pieces joined by links, numbered from 0 by their first cell; one number for each cell.
std::vector<uint32_t> components(const Links& links);

Digest digest(const Network& network);

/// Throws Error(internal), naming what is wrong, unless arrays are of one length, every number is
/// finite, normals and frames are orthonormal up to 1e-4, and links are mutual, sorted, to others,
/// and `full` at most.
void validate(const Network& network);

/// `across` by `along` cells in a flat sheet (y up) whose sides are joined, as if rolled both ways:
/// the classic stage of cellular automata. `full` is 3 (honeycomb, both numbers even), 4, 6 (the
/// number along even) or 8. Cell (x, z) has the index z * across + x. At least 4 by 4 cells.
Network flat_torus(uint32_t across, uint32_t along, uint32_t full, double spacing = 1);

}  // namespace vug::cells
