// SPDX-License-Identifier: Apache-2.0
// Internal to exchange/: USD meshes and materials.
#pragma once

#include <vug/exchange/assembly.h>
#include <vug/exchange/usd_layer.h>

#include <map>
#include <string>

namespace vug::exchange {

/// The paths of the materials of a prototype.
struct UsdMaterials {
  std::string whole;                         ///< The material of the mesh.
  std::map<std::string, std::string> rocks;  ///< Those of rocks with a look of their own.

  /// The material of a rock; of other rocks that of the mesh.
  const std::string& of(const std::string& rock) const {
    const auto found = rocks.find(rock);
    return found == rocks.end() ? whole : found->second;
  }
};

/// Writes a Mesh prim of that name, bound to the materials, with a subset for each of its rocks;
/// with levels of detail an Xform with one variant per mesh.
void write_usd_mesh(UsdLayer& out, const Prototype& prototype, const std::string& name,
                    const UsdMaterials& materials);

/// Writes a Mesh prim of that name and purpose without materials, with a subset for each of its
/// rocks.
void write_usd_bare_mesh(UsdLayer& out, const mesh::Mesh& mesh, const std::string& name,
                         const std::string& purpose);

/// "Mesh" or "Xform", depending on the levels.
std::string usd_mesh_type(const Prototype& prototype);

/// Writes a Material prim: a UsdPreviewSurface that reads varying properties from primvars of the
/// mesh.
void write_usd_material(UsdLayer& out, const Prototype& prototype, const std::string& path,
                        const std::string& name);

/// Whether both can share one material.
bool same_usd_material(const Prototype& a, const Prototype& b);

}  // namespace vug::exchange
