// SPDX-License-Identifier: Apache-2.0
// Definitions for the source file of a mesh format. The macro opens its one exported definition,
// outside of any namespace:
//   VUG_MESH_FORMAT(ply) { return mesh_format("ply", "...", "...", read, write); }
#pragma once

#include <vug/base/kind.h>
#include <vug/mesh/format.h>

#define VUG_MESH_FORMAT(name) VUG_EXPORT_KIND(vug::mesh, Format, name##_format)

namespace vug::mesh {

inline Format mesh_format(std::string name, std::string doc, std::string cite,
                          Mesh (*read)(std::string_view, const std::string&),
                          void (*write)(const Mesh&, const Comments&, const ByteSink&)) {
  return {{std::move(name), "mesh format", std::move(doc), std::move(cite), {}}, read, write};
}

}  // namespace vug::mesh
