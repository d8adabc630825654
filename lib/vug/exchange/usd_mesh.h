// Inside exchange/ only: meshes and looks as USD has them.
#pragma once

#include <vug/exchange/assembly.h>
#include <vug/exchange/usd_text.h>

#include <string>

namespace vug::exchange {

/// A Mesh prim of that name, bound to the material at that path; with coarser meshes an Xform whose
/// variants each hold one.
void write_usd_mesh(UsdText& out, const Prototype& prototype, const std::string& name,
                    const std::string& material);

/// Which of both it is.
std::string usd_mesh_type(const Prototype& prototype);

/// A Material prim: a UsdPreviewSurface that reads what varies from the mesh.
void write_usd_material(UsdText& out, const Prototype& prototype, const std::string& path,
                        const std::string& name);

/// Whether one material does for both.
bool same_usd_material(const Prototype& a, const Prototype& b);

}  // namespace vug::exchange
