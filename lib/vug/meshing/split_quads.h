// SPDX-License-Identifier: Apache-2.0
// Splits quads into triangles along the diagonal that follows the surface.
#pragma once

#include <vug/base/progress.h>
#include <vug/field/field.h>
#include <vug/meshing/faces.h>

namespace vug::meshing {

class PolishPasses;  // See polish_passes.h.

/// Whether the diagonal from corner 0 to corner 2 is not longer than the other.
bool shorter_from_0(const Face& face, const std::vector<Vec3d>& points);

/// The triangles of a quad that is split from corner 0 to 2, or from 1 to 3.
std::array<mesh::Triangle, 2> halves(const Face& face, bool from_0);

/// Splits each quad of `faces` with its vertices at `points`. Flat quads take the shorter diagonal.
/// Bent quads, for example across a crease, take the diagonal whose midpoint is nearer to the zero
/// set of `exact`, unless one of its triangles faces backwards. If `exact` is null, all take the
/// shorter diagonal.
std::vector<mesh::Triangle> split_quads(const FaceMesh& faces, const std::vector<Vec3d>& points,
                                        const field::Field* exact, double voxel,
                                        const PolishPasses& passes, Progress& progress);

}  // namespace vug::meshing
