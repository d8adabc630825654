// SPDX-License-Identifier: Apache-2.0
// Carving of facades: the solids that a facade removes from a wall or cliff and adds to it.
#pragma once

#include <vug/base/transform.h>
#include <vug/facade/tree.h>
#include <vug/field/kind.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::facade {

using TreePtr = std::shared_ptr<const Tree>;

/// The position and orientation of a facade in the world: `at` is the middle of its foot. It faces
/// +z, rotated by `yaw` (radians) about the vertical axis, counter-clockwise seen from above.
struct FacadeFrame {
  Vec3d at{0, 0, 0};
  double yaw = 0;

  /// The transform from the facade's frame (x from its left, y from its foot, z out of its plane)
  /// to the world.
  Transform transform(double width) const;
};

/// An ordered list of solids to subtract from a wall or to add to it.
struct Carving {
  struct Layer {
    bool add = false;
    field::Field solid;
  };
  std::vector<Layer> layers;
  field::Field fill;  ///< Panes, leaves, railings: a separate solid of other materials.

  field::Field applied(field::Field wall) const;
};

/// The carving of a whole tree, in the facade's frame. Offset planes come first, in the order of
/// the tree, then all holes of elements, then the solids that elements add. Throws Error(bad_input)
/// that names an element with invalid dimensions, and Error(too_large) beyond a million elements.
Carving carve(const Tree& tree);

/// The solids of a node's element, in its own frame. Throws Error(bad_input) that names the
/// element.
Solids solids_of(const Node& node);
/// The transform from the frame of a node's element, at one of its placements, to the facade's
/// frame.
Transform frame_of(const Node& node, const Placement& place);

/// Boxes around all elements of these kinds (or with these symbols), from the distance `behind`
/// their face to the distance `before` it, in the facade's frame.
field::Field zones(const Tree& tree, const std::vector<std::string>& kinds, double behind,
                   double before);

/// A wall of that thickness with the facade carved into its front face, which is the facade's
/// plane. The field stores its tree and frame; find_facade returns them.
field::Field wall(TreePtr tree, const FacadeFrame& frame, double thickness);

struct FacadeInstance {
  TreePtr tree;
  FacadeFrame frame;
};
/// A field that forwards to `field` and stores the facade that was carved into it.
field::Field with_facade(FacadeInstance placed, const field::Field& field);
/// The facade stored in a field: in a wall(), a solid with a carved facade, or an infill; nothing
/// for other fields.
std::optional<FacadeInstance> find_facade(const field::Field& field);

/// The parameters of kinds that take a facade: its field and optionally another frame.
struct FacadeParams {
  field::Field facade;
  std::optional<Vec3d> at;
  std::optional<double> yaw;

  FacadeParams();
  template <class P>
  static void describe_facade(Schema<P>& s) {
    s.param("facade", &P::facade,
            {.doc = "a grammar of kind facade, or a solid with a carved facade", .required = true});
  }
  template <class P>
  static void describe_frame(Schema<P>& s) {
    s.param("at", &P::at, any_length("middle of the facade's foot; overrides that of the facade"))
        .param("yaw", &P::yaw,
               {.doc = "rotation about the vertical axis; overrides that of the facade",
                .dimension = Dimension::angle});
  }
  /// An error message if the field is not a facade, else empty.
  std::string facade_fault() const;
  FacadeInstance placed() const;
};

using SolidKind = field::FieldKind;
/// Field kinds made from facades, from the list in CMakeLists.txt; they are added to the field
/// kinds.
const Kinds<field::Field>& solids();

}  // namespace vug::facade

/// Opens the only definition that the file of such a kind exports; see VUG_EXPORT_KIND.
#define VUG_FACADE_SOLID(name) VUG_EXPORT_KIND(vug::facade, SolidKind, name##_solid)
