// SPDX-License-Identifier: Apache-2.0
// Sections of a facade whose walls stand at different depths, such as gables that stand in front of
// the wall between them.
#pragma once

#include <vug/scan/range_image.h>

namespace vug::scan {

struct SectionOptions {
  double cell = 0.1;  ///< Side length of the cells in metres; each has its median depth.
  /// Neighbouring cells whose depths differ by less belong to one surface, metres.
  double step = 0.04;
  /// A surface that is this close to the continuation of a larger wall belongs to it, metres.
  double min_offset = 0.1;
  double min_area = 2;  ///< Smallest area of a wall, square metres.
  /// A surface with a longer side is a wall and not a pane or a door, metres. A smaller surface is
  /// a wall if it surrounds an opening of at least `min_opening` metres per side.
  double max_opening = 6;
  double min_opening = 0.5;
};

struct Sections {
  int count = 1;
  /// Section of each pixel; empty if there is only one. Section 0 is the largest wall.
  std::vector<uint8_t> of_pixel;

  /// A mask of the section's pixels; empty if there is only one section.
  std::vector<uint8_t> mask(int section) const;
};

/// Divides the image into the walls at different depths. Pixels that show no wall belong to the
/// section of the nearest wall, so that each opening is one of the wall around it. The result does
/// not depend on the number of threads.
Sections wall_sections(const RangeImage& range, const SectionOptions& options = {});

}  // namespace vug::scan
