// SPDX-License-Identifier: Apache-2.0
// Internal to exchange/: USD meshes and materials.
#pragma once

#include <vug/exchange/assembly.h>
#include <vug/exchange/usd_text.h>

#include <string>

namespace vug::exchange {

/// Writes a Mesh prim of that name, bound to the material at that path; with levels of detail an
/// Xform with one variant per mesh.
void write_usd_mesh(UsdText& out, const Prototype& prototype, const std::string& name,
                    const std::string& material);

/// "Mesh" or "Xform", depending on the levels.
std::string usd_mesh_type(const Prototype& prototype);

/// Writes a Material prim: a UsdPreviewSurface that reads varying properties from primvars of the
/// mesh.
void write_usd_material(UsdText& out, const Prototype& prototype, const std::string& path,
                        const std::string& name);

/// Whether both can share one material.
bool same_usd_material(const Prototype& a, const Prototype& b);

}  // namespace vug::exchange
