// Inside of flora/ only: the outline of a tube's solid, cut along its middle line.
#pragma once

#include <vug/flora/tube.h>

namespace vug::flora {

/// A ring of vertices: where along, and how far out.
struct ProfileRow {
  double along = 0;
  double share = 1;    ///< Of the displaced radius, or of the inner one.
  bool inner = false;  ///< On the wall of a chamber.
  bool cut = false;    ///< On a face across the stem.
};

/// An outline that turns about the middle line; on the left of its way lies the solid's outside.
struct Profile {
  std::vector<ProfileRow> rows;
  bool ring = false;  ///< Closed in itself, else closed by a vertex on the middle line at each end.
};

/// The outer surface with the chambers that are open first, then the closed chambers.
std::vector<Profile> profiles(const Tube& tube);

}  // namespace vug::flora
