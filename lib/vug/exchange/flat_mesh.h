// A scene as the one mesh that simple formats hold, and the parts of that.
#pragma once

#include <vug/exchange/format.h>
#include <vug/mesh/comments.h>

namespace vug::exchange {

/// The mesh where `place` takes it: also mirrored, its outside stays outside; no other attributes
/// turn with it.
mesh::Mesh transformed(mesh::Mesh mesh, const Transform& place);

/// What a mesh file says of where it comes from and what its numbers mean.
mesh::Comments comments_of(const Provenance& from, const Space& space);

/// All parts where they stand, in one mesh. Every vertex has a colour, its own or its look's; other
/// attributes are 0 where a part has none.
mesh::Mesh flat_mesh(const Assembly& assembly);

/// Writes that by the mesh format of the file's extension, with provenance in its comments.
WriteReport write_flat_mesh(const Assembly& assembly, const std::filesystem::path& file,
                            const FormatOptions& options, Progress& progress);

std::vector<std::pair<std::string, std::string>> read_flat_metadata(std::string_view bytes,
                                                                    const std::string& file);

}  // namespace vug::exchange
