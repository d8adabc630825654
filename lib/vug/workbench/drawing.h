// SPDX-License-Identifier: Apache-2.0
// The picture of a facade state as plain rectangles, which a window paints over the photo.
#pragma once

#include <vug/modeller/facade_state.h>

#include <string>
#include <vector>

namespace vug::workbench {

struct Shape {
  enum class Kind {
    part,     ///< A divided area.
    open,     ///< An area that no rule divides yet.
    element,  ///< A window, a door, ...
    ghost,    ///< A part that an action would make.
  };
  Kind kind = Kind::part;
  facade::Rect rect;   ///< On the facade's plane, metres, y up.
  int node = 0;        ///< In the state; for ghosts in the state after the action.
  bool first = true;   ///< The derived instance; others are copies.
  std::string symbol;  ///< "PartFacade", "window".
};

/// All instances of all nodes, parents before children.
std::vector<Shape> shapes(const modeller::FacadeState& state);

/// All instances of one node.
std::vector<facade::Rect> instances(const modeller::FacadeState& state, int node);

/// The parts that an action adds below a node: those of `after` that `before` does not have.
std::vector<Shape> ghosts(const modeller::FacadeState& before, int node,
                          const modeller::FacadeState& after);

/// A mapping between the facade's plane and a canvas, whose y axis points down.
struct CanvasView {
  double scale = 50;    ///< Pixels per metre.
  double x = 0, y = 0;  ///< The canvas position of the facade's lower left corner, pixels.

  double to_canvas_x(double metres) const { return x + scale * metres; }
  double to_canvas_y(double metres) const { return y - scale * metres; }
  double to_facade_x(double pixels) const { return (pixels - x) / scale; }
  double to_facade_y(double pixels) const { return (y - pixels) / scale; }

  /// The view magnified around a point of the canvas, which stays at its place.
  CanvasView zoomed(double factor, double at_x, double at_y) const;
  CanvasView panned(double dx, double dy) const { return {scale, x + dx, y + dy}; }
  /// The view of a whole facade in a canvas with a margin, in pixels.
  static CanvasView whole(double width, double height, double canvas_width, double canvas_height,
                          double margin = 24);
};

/// The position rounded to the smallest step of 1, 2 or 5 times a power of ten that is at least a
/// pixel, so that a drag gives round numbers at any magnification; at least 1 mm.
double snapped(double metres, double pixels_per_metre);

/// Range of CanvasView::scale.
constexpr double kMinScale = 1, kMaxScale = 5000;

}  // namespace vug::workbench
