// SPDX-License-Identifier: Apache-2.0
// Internal to volume/: the values of one block of 8^3 voxels.
#pragma once

#include <vug/field/near_surface.h>
#include <vug/volume/lattice.h>

namespace vug::volume {

/// In OpenVDB's order: z varies fastest, and each mask word holds one x.
struct Block {
  static constexpr int kSize = 512;
  alignas(32) float values[kSize];
  uint64_t active[8];

  /// Gives all voxels one value, and none is active.
  void fill(float value);
  bool any_active() const;
};

/// The node of a field whose first-order distances near its surface are the values of its blocks,
/// or null.
const field::NearSurface* near_surface_of(const field::Field& field, const NarrowBand& band);

/// Fills the block whose first lattice point is `cell.origin` with clamped values; voxels inside
/// the band are active. Single precision is accurate if the point is near the origin.
void evaluate(const field::Field& field, const Cell& cell, const NarrowBand& band,
              field::Scratch& scratch, Block& block);

}  // namespace vug::volume
