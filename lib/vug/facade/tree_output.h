// SPDX-License-Identifier: Apache-2.0
// Output of facades: JSON, the notation of ripperda2009, SVG over a picture, and a list of elements
// as CSV. The same tree gives the same bytes.
#pragma once

#include <vug/facade/tree.h>

#include <string>

namespace vug::facade {

/// {"name", "width", "height", "theta", "nodes": [{"id", "parent", "symbol", "rule", "rect",
/// "copies", "split", "given", "numbers", "children"}], "elements": [{"kind", "node", "rect",
/// "mirrored"}]}. Lengths are in metres.
std::string tree_json(const Tree& tree);

/// Facade(0, 0, 12, 9, (FacadeRow(3, ...), PartFacade(6, RegularIdenticalGrid(4, 2, ...)))): each
/// symbol with the numbers of its cell and its split in metres, then its parts; elements with
/// width, height and the position of their lower left corner.
std::string theta(const Tree& tree);

/// CSV with the columns kind,x,y,width,height,mirrored and one line per occurrence of an element,
/// in metres.
std::string elements_csv(const Tree& tree);

struct SvgOptions {
  std::string picture;  ///< Background picture, stretched to the drawing; empty: none.
  /// The part of the picture that is stretched, as shares of its width and height from its upper
  /// left corner.
  Rect part = {0, 0, 1, 1};
  double pixels = 1000;  ///< Width of the drawing, pixels.
};

/// A drawing of all elements as rectangles, with one colour per kind, and of the scopes as thin
/// lines; stuck ones are orange. Tooltips show symbol, size and rule.
std::string elevation_svg(const Tree& tree, const SvgOptions& options = {});

}  // namespace vug::facade
