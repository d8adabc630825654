// From rectangles to solids: what a facade takes out of a wall or a cliff and what it adds.
#pragma once

#include <vug/base/transform.h>
#include <vug/facade/tree.h>
#include <vug/field/kind.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::facade {

using TreePtr = std::shared_ptr<const Tree>;

/// Where a facade stands in the world: `at` is the middle of its foot. It looks along +z, turned by
/// `yaw` (radians) about the upright axis, counter-clockwise seen from above.
struct FacadeFrame {
  Vec3d at{0, 0, 0};
  double yaw = 0;

  /// From the facade's frame (x from its left, y from its foot, z out of its plane) to the world.
  Transform transform(double width) const;
};

/// Steps on a wall, in order: matter taken out, or added.
struct Carving {
  struct Layer {
    bool add = false;
    field::Field solid;
  };
  std::vector<Layer> layers;
  field::Field fill;  ///< Panes, leaves, railings: matter of its own.

  field::Field applied(field::Field wall) const;
};

/// The carving of a whole tree, in the facade's frame. Planes that jump back or forth come first,
/// in the order of the tree; then all holes of elements, then what elements add. Error(bad_input)
/// names the element whose measures do not fit; Error(too_large) beyond a million elements.
Carving carve(const Tree& tree);

/// What the element of a node is made of, in its own frame. Error(bad_input) names the element.
Solids solids_of(const Node& node);
/// From the frame of a node's element at one of its places to the facade's.
Transform frame_of(const Node& node, const Placement& place);

/// Boxes around all elements of these kinds (or whose symbols are called so), from `behind` the
/// face of each to `before` it, in the facade's frame.
field::Field zones(const Tree& tree, const std::vector<std::string>& kinds, double behind,
                   double before);

/// A wall of that thickness with the facade carved into it, whose plane is the wall's front face.
/// The field remembers its tree and frame; facade_of finds them.
field::Field wall(TreePtr tree, const FacadeFrame& frame, double thickness);

struct FacadeInstance {
  TreePtr tree;
  FacadeFrame frame;
};
/// The field, which passes everything on, with what was carved into it.
field::Field with_facade(FacadeInstance placed, const field::Field& field);
/// What is remembered of a facade: of wall(), of a solid that one was carved into, of an infill;
/// nothing for other fields.
std::optional<FacadeInstance> find_facade(const field::Field& field);

/// The argument of kinds that take a facade: its field as it is, and perhaps another frame.
struct FacadeParams {
  field::Field facade;
  std::optional<Vec3d> at;
  std::optional<double> yaw;

  FacadeParams();
  template <class P>
  static void describe_facade(Schema<P>& s) {
    s.param(
        "facade", &P::facade,
        {.doc = "a grammar of kind facade, or a solid that one is carved into", .required = true});
  }
  template <class P>
  static void describe_frame(Schema<P>& s) {
    s.param("at", &P::at, any_length("the middle of its foot, in place of the facade's"))
        .param("yaw", &P::yaw,
               {.doc = "its turn, in place of the facade's", .dimension = Dimension::angle});
  }
  /// A sentence where the field is no facade.
  std::string facade_fault() const;
  FacadeInstance placed() const;
};

using SolidKind = field::FieldKind;
/// Fields that are made of facades; they join the family of field kinds. Made from the list in
/// CMakeLists.txt.
const Kinds<field::Field>& solids();

}  // namespace vug::facade

/// Opens the one function that the file of such a kind exports.
#define VUG_FACADE_SOLID(name) VUG_EXPORT_KIND(vug::facade, SolidKind, name##_solid)
