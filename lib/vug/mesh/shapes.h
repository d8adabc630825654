// Small closed meshes with known answers: for tests, examples and stand-ins. All outward.
#pragma once

#include <vug/mesh/mesh.h>

namespace vug::mesh {

/// An axis-aligned box of 12 triangles.
Mesh box_mesh(const Box3d& box);

/// An icosahedron split `levels` times (20 * 4^levels triangles), its vertices on the sphere.
Mesh sphere_mesh(const Vec3d& centre, double radius, int levels);

/// A torus about the y axis through the origin; `around` by `across` quads, each at least 3.
Mesh torus_mesh(double radius, double tube, int around, int across);

/// Both meshes side by side in one; attributes must agree in name and arity.
Mesh joined(const Mesh& a, const Mesh& b);

}  // namespace vug::mesh
