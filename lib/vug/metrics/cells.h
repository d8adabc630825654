// SPDX-License-Identifier: Apache-2.0
// The volume measure of the paper: cells of the sampling lattice with all eight corners inside.
#pragma once

#include <vug/base/progress.h>
#include <vug/field/field.h>

#include <cstdint>

namespace vug::metrics {

/// The number of cells with edge `edge` (metres), on the lattice through the origin, with all 8
/// corners inside (value < 0): C of eq. 10. Multiplied by edge^3 it converges to the volume from
/// below. Blocks that the field's bounds decide are counted without sampling. Throws
/// Error(bad_input) unless the field's bounds are finite and edge > 0; Error(too_large) beyond 2^31
/// cells along an axis.
uint64_t inside_cells(const field::Field& field, double edge,
                      Progress& progress = Progress::none());

/// V_M of eq. 10, cubic metres.
double volume_cells(const field::Field& field, double edge, Progress& progress = Progress::none());

}  // namespace vug::metrics
