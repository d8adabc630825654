// SPDX-License-Identifier: Apache-2.0
// Small closed meshes with known measures, for tests, examples and placeholders. All are oriented
// outwards.
#pragma once

#include <vug/mesh/mesh.h>

namespace vug::mesh {

/// An axis-aligned box of 12 triangles.
Mesh box_mesh(const Box3d& box);

/// An icosahedron subdivided `levels` times (20 * 4^levels triangles), with its vertices on the
/// sphere.
Mesh sphere_mesh(const Vec3d& centre, double radius, int levels);

/// A torus about the y axis through the origin, of `around` by `across` quads, each number at least
/// 3.
Mesh torus_mesh(double radius, double tube, int around, int across);

/// Both meshes in one, not merged; attributes must agree in name and arity.
Mesh joined(const Mesh& a, const Mesh& b);

}  // namespace vug::mesh
