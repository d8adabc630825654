// SPDX-License-Identifier: Apache-2.0
// Euclidean distances in the band of a level set. The values of a field are distances only near
// the faces of its operands: minima and maxima are too small outside sharp edges, and the
// first-order distances of other fields are off wherever the slope changes.
#pragma once

#include <vug/base/progress.h>
#include <vug/field/field.h>
#include <vug/volume/level_set.h>

namespace vug::meshing {

/// The level set with the distance from each point of the band to the nearest point of the surface
/// of `exact`, the field that it samples; signs stay. The nearest point of the level set's own
/// polygons gives the start of a search on the field, in which tangent planes keep both sides of
/// an edge. The same bytes for any number of threads. Throws Error(cancelled).
volume::LevelSet exact_distances(const volume::LevelSet& level_set, const field::Field& exact,
                                 Progress& progress = Progress::none());

}  // namespace vug::meshing
