// Which part of a facade a place of its surface belongs to: what meshes of carved facades carry.
#pragma once

#include <vug/facade/carve.h>
#include <vug/mesh/box_tree.h>
#include <vug/mesh/mesh.h>

#include <memory>
#include <string>
#include <vector>

namespace vug::facade {

/// How far weather may have moved a surface from what was carved, metres.
inline constexpr double kReach = 0.3;

/// A carved facade, asked for the node whose surface is nearest. Surfaces are what elements cut and
/// add, the rectangles of nodes in their planes (but of holes), and the sides of planes that jump.
/// Immutable.
class Semantics {
 public:
  /// Error where an element's measures do not fit, as from carve().
  explicit Semantics(FacadeInstance placed);

  const Tree& tree() const { return *placed_.tree; }
  /// Index in Tree::nodes, the inner one of those that are equally near (in one plane the part
  /// before the whole); -1 where nothing of the facade is within kReach. World space, metres.
  int node_at(const Vec3d& p) const;

 private:
  struct Piece {
    int node = 0;
    Box3d box;
    field::Field solid;  ///< Unused where the box is a flat rectangle, whose distance it is itself.
    bool flat = false;
  };
  void add(int node, field::Field solid);

  FacadeInstance placed_;
  Transform to_facade_;
  std::vector<Piece> pieces_;
  mesh::BoxTree boxes_;
};

using Facades = std::vector<std::shared_ptr<const FacadeInstance>>;

/// Adds to a mesh of these facades, vertex by vertex, "node", the number that `vug tree --json`
/// gives the node (-1: none; those of a second facade follow those of the first), and for each kind
/// of element that stands in them, and for "wall", 1 where a vertex is of such an element, else 0.
/// What is of a facade and of no element is wall.
void add_semantics(mesh::Mesh& mesh, const Facades& facades);
/// The names of the latter.
std::vector<std::string> element_names(const Facades& facades);
/// The names of all these attributes.
std::vector<std::string> semantic_names(const Facades& facades);

}  // namespace vug::facade
