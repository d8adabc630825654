// SPDX-License-Identifier: Apache-2.0
// Upper bounds of the Hausdorff distance between two surfaces, which hold for all of their points.
#pragma once

#include <vug/mesh/mesh.h>

namespace vug::mesh {

/// A distance that no point of either surface exceeds from the other surface, and that is at most
/// 2 % larger than the Hausdorff distance. Triangles are subdivided until their bounds suffice
/// (Guthe, Borodin and Klein 2005, "Fast and accurate Hausdorff distance calculation between
/// meshes", cite guthe2005): the distance from one triangle of the other surface is a convex
/// function, so it is largest at a corner, and the distance from the surface changes at most as
/// much as the point moves. The bound is not smaller than 1/64 of the mean length of an edge of the
/// finer mesh, and it may be more than 2 % larger where a triangle would need thousands of pieces.
/// 0 if either mesh has no triangles. The same result for any number of threads.
double hausdorff_bound(const Mesh& a, const Mesh& b);

}  // namespace vug::mesh
