// SPDX-License-Identifier: Apache-2.0
// Semantic labels of carved facades: the node to which each point of a surface belongs, stored as
// mesh attributes.
#pragma once

#include <vug/facade/carve.h>
#include <vug/mesh/box_tree.h>
#include <vug/mesh/mesh.h>

#include <memory>
#include <string>
#include <vector>

namespace vug::facade {

/// Maximum distance between a weathered surface and the carved one, metres.
inline constexpr double kMaxWeathering = 0.3;

/// Nearest-surface queries on a carved facade. The surfaces are the solids that elements cut and
/// add, the rectangles of nodes in their planes (except holes), and the sides of offset planes.
/// Immutable.
class Semantics {
 public:
  /// Throws an Error if an element's dimensions are invalid, like carve().
  explicit Semantics(FacadeInstance placed);

  const Tree& tree() const { return *placed_.tree; }
  /// Index in Tree::nodes of the nearest surface at a world-space point in metres; of equally near
  /// nodes the inner one (within a plane, the part rather than the whole). -1 if no surface is
  /// within kMaxWeathering.
  int node_at(const Vec3d& p) const;

 private:
  struct Piece {
    int node = 0;
    Box3d box;
    field::Field solid;  ///< Unused for flat rectangles; their distance is that of the box.
    bool flat = false;
  };
  void add(int node, field::Field solid);

  FacadeInstance placed_;
  Transform to_facade_;
  std::vector<Piece> pieces_;
  mesh::BoxTree boxes_;
};

using Facades = std::vector<std::shared_ptr<const FacadeInstance>>;

/// Adds vertex attributes to a mesh of these facades: "node" is the node's number in `vug tree
/// --json`
/// (-1: none; the numbers of a second facade follow those of the first). For each kind of element
/// in the facades and for "wall" there is an attribute of that name, which is 1 on such elements,
/// else 0. Vertices that belong to a facade but to no element are wall.
void add_semantics(mesh::Mesh& mesh, const Facades& facades);
/// The names of the attributes for elements and "wall".
std::vector<std::string> element_names(const Facades& facades);
/// The names of all these attributes.
std::vector<std::string> semantic_names(const Facades& facades);

}  // namespace vug::facade
