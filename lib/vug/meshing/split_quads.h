// Quads into triangles, along the diagonal that keeps to the surface.
#pragma once

#include <vug/base/progress.h>
#include <vug/field/field.h>
#include <vug/meshing/faces.h>

namespace vug::meshing {

/// Cuts each quad of `faces` with its vertices at `points`. Flat quads take the shorter diagonal;
/// bent ones (over a crease, say) the one whose middle is nearer to the zero of `exact`, unless
/// one of its triangles faces backwards. `exact` may be null: then the shorter one.
std::vector<mesh::Triangle> split_quads(const FaceMesh& faces, const std::vector<Vec3d>& points,
                                        const field::Field* exact, double voxel,
                                        Progress& progress);

}  // namespace vug::meshing
