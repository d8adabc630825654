// The pieces that elements are put together from, in an element's frame.
#pragma once

#include <vug/facade/element.h>
#include <vug/facade/rect.h>

namespace vug::facade {

/// A box over a rectangle of the face, from z = `back` to `front`; edges rounded by `rounding`.
field::Field block(const Rect& rect, double back, double front, double rounding = 0);

/// How far holes begin before the face, metres. Nothing of it is left over them, not even after
/// weather has moved what was carved by half of that.
inline constexpr double kCutMargin = 0.1;

/// Thickness of panes. Glass is thinner, but a sheet thinner than a voxel falls between the samples
/// of a level set; only its front is seen.
inline constexpr double kPane = 0.06;

/// What closes an opening at its top.
enum class Head { flat, segmental, round, pointed };

/// The rise of the head above its springing in an opening of that size: `rise` where it is above 0,
/// else the kind's own (segmental a sixth of the width, round half of it, pointed the height of an
/// equilateral arch), at most the height.
double rise_of(Head head, double rise, double width, double height);

/// A box with such a head, over a rectangle, from z = `back` to `front`.
field::Field arched_block(const Rect& rect, Head head, double rise, double back, double front);

/// The measures of a hole in a wall and of what goes around it. Base of windows and doors.
struct Opening {
  double reveal = 0.2;  ///< Depth of the wall before the pane or leaf.
  Head head = Head::flat;
  double rise = 0;            ///< 0: that of the head's kind.
  double frame = 0;           ///< Width of the moulding around, outside of the rectangle.
  double frame_depth = 0.04;  ///< How far it stands out.
  double sill = 0;            ///< How far the sill stands out; 0: none.
  double sill_height = 0.08;
  double lintel = 0;  ///< How far the lintel or hood stands out; 0: none.
  double lintel_height = 0.2;
  double keystone = 0;  ///< How far the keystone stands out; 0: none.

  /// The hole (to `depth` behind the face), the moulding, the sill, the lintel.
  Solids around(double width, double height, double depth) const;
  /// A sheet within the hole between two depths behind the face.
  field::Field sheet(double width, double height, double back, double front) const;
  std::string opening_fault() const;
};

/// Describes these measures under their names; P derives from Opening.
template <class P>
void describe_opening(Schema<P>& s);

}  // namespace vug::facade

#include <vug/facade/blocks_inl.h>
