// SPDX-License-Identifier: Apache-2.0
#include <vug/render/film/tile_progress.h>

namespace vug::render {

TileProgress::TileProgress(const Region& pixels, uint32_t first, uint32_t last, int side)
    : region(pixels),
      tile_size(side),
      begin(first),
      end(last),
      done(pixels.tiles(side), first),
      converged(done.size(), 0) {}

uint64_t TileProgress::missing() const {
  uint64_t count = 0;
  for (size_t i = 0; i < done.size(); ++i)
    if (!converged[i]) count += tile(i).pixels() * (end - done[i]);
  return count;
}

double TileProgress::fraction() const {
  const auto all = static_cast<double>(samples());
  return all > 0 ? 1 - static_cast<double>(missing()) / all : 1;
}

}  // namespace vug::render
