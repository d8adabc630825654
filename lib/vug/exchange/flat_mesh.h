// SPDX-License-Identifier: Apache-2.0
// A scene as a single mesh for simple formats.
#pragma once

#include <vug/exchange/format.h>
#include <vug/mesh/comments.h>

namespace vug::exchange {

/// Transforms a mesh. A mirrored mesh keeps its outside; only normals rotate with it, no other
/// attributes.
mesh::Mesh transformed(mesh::Mesh mesh, const Transform& place);

/// The comments of a mesh file: provenance and meaning of the coordinates.
mesh::Comments comments_of(const Provenance& from, const Space& space);

/// All instances in one mesh. Every vertex has a colour, its own or that of its look; other
/// attributes are 0 where a prototype lacks them.
mesh::Mesh flat_mesh(const Assembly& assembly);

/// Writes the flat mesh in the format of the file's extension, with provenance in its comments.
WriteReport write_flat_mesh(const Assembly& assembly, const std::filesystem::path& file,
                            const FormatOptions& options, Progress& progress);

std::vector<std::pair<std::string, std::string>> read_flat_metadata(std::string_view bytes,
                                                                    const std::string& file);

}  // namespace vug::exchange
