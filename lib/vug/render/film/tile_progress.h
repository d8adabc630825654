// SPDX-License-Identifier: Apache-2.0
// The size of the tiles of a picture, and how far they are rendered.
#pragma once

#include <vug/render/film/region.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vug::render {

/// The range of samples to be taken of the pixels of a region, and the completed part of it.
struct TileProgress {
  static constexpr int kTileSize = 16;  ///< Default side of a tile in pixels.

  Region region;
  int tile_size = kTileSize;
  uint32_t begin = 0, end = 0;     ///< The range of samples to be taken of each pixel.
  std::vector<uint32_t> done;      ///< For each tile: samples from `begin` up to this one are done.
  std::vector<uint8_t> converged;  ///< For each tile: 1 once its noise is low enough.

  TileProgress() = default;
  /// Nothing is done yet.
  TileProgress(const Region& region, uint32_t begin, uint32_t end, int tile_size = kTileSize);

  Region tile(size_t index) const { return region.tile(index, tile_size); }
  /// The number of samples of all pixels, and an upper bound of the missing ones.
  uint64_t samples() const { return region.pixels() * uint64_t{end - begin}; }
  uint64_t missing() const;
  bool complete() const { return missing() == 0; }
  /// The fraction of samples that are done or no longer needed, 0 to 1.
  double fraction() const;
};

}  // namespace vug::render
