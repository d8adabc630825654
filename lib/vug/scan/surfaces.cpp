// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/scan/mask.h>
#include <vug/scan/surfaces.h>

#include <algorithm>
#include <cmath>

namespace vug::scan {
namespace {

/// Closes gaps up to twice the radius. Beyond the sides and the top the mask is empty; at the
/// bottom is the ground.
Mask close_gaps(const Mask& solid, int radius) {
  Mask wide(solid.width + 2 * radius, solid.height + radius);
  for (int y = 0; y < solid.height; ++y)
    for (int x = 0; x < solid.width; ++x)
      wide.on[wide.index(x + radius, y + radius)] = solid.at(x, y);
  wide = closed(wide, radius);
  Mask out = solid;
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x)
      out.on[out.index(x, y)] |= wide.on[wide.index(x + radius, y + radius)];
  return out;
}

}  // namespace

SurfaceMap surface_map(const RangeImage& range, const SurfaceOptions& options) {
  if (!std::isfinite(options.set_back) || !(options.hull >= 0 && std::isfinite(options.hull)))
    throw Error(ErrorCode::bad_input,
                "the set-back and the hull must be finite, the hull not negative");
  SurfaceMap out;
  if (options.bent) out.sections = wall_sections(range, options.sections);
  for (int section = 0; section < out.sections.count; ++section)
    out.walls.push_back(options.bent ? fit_wall(range, options.wall, out.sections.mask(section))
                                     : flat_wall());
  const double automatic = options.bent ? std::max(0.03, 3 * out.walls[0].rms) : 0.05;
  out.set_back = options.set_back >= 0 ? options.set_back : automatic;
  Mask solid(range.width, range.height);
  for (size_t p = 0; p < range.pixel_count(); ++p) solid.on[p] = !std::isnan(range.depth[p]);
  const int radius = pixels_of(options.hull / 2, range.pixel, std::max(range.width, range.height));
  const Mask outside = outside_of(close_gaps(solid, radius));
  out.surface.assign(range.pixel_count(), Surface::outside);
  parallel_for(static_cast<size_t>(range.height), [&](size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < range.width; ++x) {
      const size_t p = range.index(x, y);
      if (!solid.on[p]) {
        out.surface[p] = outside.on[p] ? Surface::outside : Surface::nothing;
      } else {
        const double before = range.depth[p] - out.wall(p).at(range.pixel_center(x, y));
        out.surface[p] = before < -out.set_back ? Surface::behind : Surface::wall;
      }
    }
  });
  return out;
}

}  // namespace vug::scan
