// SPDX-License-Identifier: Apache-2.0
// Building blocks of elements (boxes, arched heads, openings with surround), in an element's frame.
#pragma once

#include <vug/facade/element.h>
#include <vug/facade/rect.h>

namespace vug::facade {

/// A box over a rectangle of the face, from z = `back` to `front`; edges rounded by `rounding`.
field::Field block(const Rect& rect, double back, double front, double rounding = 0);

/// How far holes start in front of the face, metres, so that no wall remains in front of them, even
/// after weathering has moved the carved surface by half of that.
inline constexpr double kCutMargin = 0.1;

/// Thickness of panes, metres. Real glass is thinner, but a sheet thinner than a voxel is missed by
/// the samples of a level set; only its front is visible.
inline constexpr double kPane = 0.06;

/// The shape of an opening's top.
enum class Head { flat, segmental, round, pointed };

/// The rise of the head above its springing in an opening of that size, in metres: `rise` if
/// positive, else the head's default (segmental: a sixth of the width, round: half of it, pointed:
/// the height of an equilateral arch), at most the height.
double rise_of(Head head, double rise, double width, double height);

/// A box with such a head over a rectangle, from z = `back` to `front`.
field::Field arched_block(const Rect& rect, Head head, double rise, double back, double front);

/// The dimensions in metres of a hole in a wall and of its surround. Base of windows and doors.
struct Opening {
  double reveal = 0.2;  ///< Depth of the hole in front of the pane or leaf.
  Head head = Head::flat;
  double rise = 0;            ///< 0: the head's default.
  double frame = 0;           ///< Width of the moulding around the rectangle.
  double frame_depth = 0.04;  ///< Projection of the moulding.
  double sill = 0;            ///< Projection of the sill; 0: no sill.
  double sill_height = 0.08;
  double lintel = 0;  ///< Projection of the lintel or hood; 0: no lintel.
  double lintel_height = 0.2;
  double keystone = 0;  ///< Projection of the keystone; 0: no keystone.

  /// The hole (to `depth` behind the face), the moulding, the sill, the lintel.
  Solids around(double width, double height, double depth) const;
  /// A sheet that fills the hole between two depths behind the face.
  field::Field sheet(double width, double height, double back, double front) const;
  std::string opening_fault() const;
};

/// Describes these parameters; P derives from Opening.
template <class P>
void describe_opening(Schema<P>& s);

}  // namespace vug::facade

#include <vug/facade/blocks_inl.h>
