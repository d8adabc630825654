// SPDX-License-Identifier: Apache-2.0
// Inside flora/ only: the outline of a tube's solid in a section along its middle line.
#pragma once

#include <vug/flora/tube.h>

namespace vug::flora {

/// A ring of vertices at one position along the tube.
struct ProfileRow {
  double along = 0;
  double share = 1;    ///< Share of the displaced radius, or of the inner radius.
  bool inner = false;  ///< On the wall of a chamber.
  bool cut = false;    ///< On a face across the stem.
};

/// An outline to be revolved about the middle line; the outside of the solid is to its left.
struct Profile {
  std::vector<ProfileRow> rows;
  /// Whether the outline is closed; otherwise a vertex on the middle line closes each end.
  bool ring = false;
};

/// The outer surface including open chambers first, then the closed chambers.
std::vector<Profile> profiles(const Tube& tube);

}  // namespace vug::flora
