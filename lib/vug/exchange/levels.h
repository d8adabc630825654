// SPDX-License-Identifier: Apache-2.0
// Levels of detail: simplified meshes with their distances from the originals.
#pragma once

#include <vug/base/progress.h>
#include <vug/exchange/assembly.h>

namespace vug::exchange {

/// Simplifies a mesh to about the fraction `share` of its triangles, with a subset of its vertices,
/// by edge collapses with quadric error metrics (Garland and Heckbert 1997, "Surface simplification
/// using quadric error metrics", cite garland1997) in meshoptimizer. Components are preserved, and
/// so are the attributes of the remaining vertices.
mesh::Mesh coarser(const mesh::Mesh& mesh, double share = 0.25);

/// The Hausdorff distance between two surfaces: the largest distance of a point on either surface
/// to the other. It is measured at vertices, edge midpoints and triangle centroids, so it is a
/// lower bound. 0 if either mesh has no triangles.
double hausdorff_distance(const mesh::Mesh& a, const mesh::Mesh& b);

/// Adds `count` levels to every prototype, each with a quarter of the triangles of the previous
/// one; fewer if a mesh cannot be simplified further: a level has at least four triangles, the
/// minimum of a solid, and at most three quarters of the previous level.
void add_levels(Assembly& assembly, int count, Progress& progress = Progress::none());

/// The assembly with level `number` (from 1) instead of its meshes, or the coarsest existing one.
Assembly at_level(const Assembly& assembly, int number);

}  // namespace vug::exchange
