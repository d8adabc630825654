// Levels of detail: the same meshes with fewer triangles, and how far they are off.
#pragma once

#include <vug/base/progress.h>
#include <vug/exchange/assembly.h>

namespace vug::exchange {

/// About a quarter as many triangles, from the mesh's own vertices, by edge collapses that weigh
/// quadrics of error (Garland and Heckbert 1997, "Surface simplification using quadric error
/// metrics", cite garland1997) in meshoptimizer; whole pieces stay, and so do attributes where
/// vertices do.
mesh::Mesh coarser(const mesh::Mesh& mesh, double share = 0.25);

/// The Hausdorff distance between two surfaces: the farthest that a point of either is from the
/// other. Measured at vertices, at middles of edges and of triangles, so it is met from below.
/// 0 where one of them has no triangles.
double hausdorff_distance(const mesh::Mesh& a, const mesh::Mesh& b);

/// Adds `count` levels to every part, each a quarter of the one before; fewer where a mesh will not
/// go further down: a level has at least four triangles, the fewest of a solid, and at most three
/// quarters of those before.
void add_levels(Assembly& assembly, int count, Progress& progress = Progress::none());

/// The assembly with level `number` (from 1) in place of its meshes, or the coarsest that there is.
Assembly at_level(const Assembly& assembly, int number);

}  // namespace vug::exchange
