// Facades to read: JSON and the notation of ripperda2009 for programs, SVG over a picture for
// people, a list of elements for whoever sets them. The same tree gives the same bytes.
#pragma once

#include <vug/facade/tree.h>

#include <string>

namespace vug::facade {

/// {"name", "width", "height", "theta", "nodes": [{"id", "parent", "symbol", "rule", "rect",
/// "copies", "split", "given", "numbers", "children"}], "elements": [{"kind", "node", "rect",
/// "mirrored"}]}, metres.
std::string tree_json(const Tree& tree);

/// Facade(0, 0, 12, 9, (FacadeRow(3, ...), PartFacade(6, RegularIdenticalGrid(4, 2, ...)))): each
/// symbol with its place's and its split's numbers in metres, then its parts; elements with width,
/// height and the place of their lower left corner.
std::string theta(const Tree& tree);

/// kind,x,y,width,height,mirrored with one line for each element at each place, metres.
std::string elements_csv(const Tree& tree);

struct SvgOptions {
  std::string picture;   ///< Named in the drawing as what lies below, stretched; empty: none.
  double pixels = 1000;  ///< Width of the drawing.
};

/// Rectangles of all elements, one colour for each kind, and of the scopes as thin lines; stuck
/// ones are orange. Hovering over one tells its symbol, size and rule.
std::string elevation_svg(const Tree& tree, const SvgOptions& options = {});

}  // namespace vug::facade
