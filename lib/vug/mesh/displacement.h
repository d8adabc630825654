// SPDX-License-Identifier: Apache-2.0
// Measures the displacements of the vertices of a mesh, such as those by cells, and shortens those
// that fold it or make it intersect itself.
#pragma once

#include <vug/mesh/mesh.h>

namespace vug::mesh {

/// The largest distance that a vertex moved, in metres; 0 for meshes without vertices.
double max_displacement(const Mesh& before, const Mesh& after);

/// The triangles whose normal turned by more than 90 degrees since their vertices moved from
/// `before`, ascending. On a surface that was smooth before, these are folds.
std::vector<uint32_t> flipped_triangles(const std::vector<Vec3f>& before, const Mesh& after);

/// The flipped triangles whose normals are also opposed to the surface around them, ascending:
/// visible folds. The sides of a tip that was pressed flat turn as far, but agree with each other.
std::vector<uint32_t> folded_triangles(const std::vector<Vec3f>& before, const Mesh& after);

/// Changes the displacements from `before` until no triangle is folded, and returns the number of
/// vertices that this changed. In each round, vertices of folded triangles take the mean
/// displacement of their triangles' vertices (Laplacian smoothing, field1988): a triangle whose
/// vertices move alike does not turn. After 30 rounds, displacements that still fold a triangle are
/// also halved, as in the backtracking of smith2015, until they are 0. All other vertices keep
/// their displacement. If vertices moved `along_normals`, which presses no tip flat, the 30 rounds
/// also smooth the other flipped triangles. The result is the same for any number of threads.
size_t prevent_folds(const std::vector<Vec3f>& before, Mesh& after, bool along_normals);

/// Shortens the displacements from `before` until no triangle intersects another (see retreat.h).
/// Meshes remain unchanged if triangles that intersect also do so before: they would be held where
/// they are.
void prevent_crossings(const std::vector<Vec3f>& before, Mesh& after);

}  // namespace vug::mesh
