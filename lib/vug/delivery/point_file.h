// Points as a mesh file without triangles, for programs that cannot read those of .vdb files.
#pragma once

#include <vug/mesh/comments.h>
#include <vug/volume/points.h>

#include <filesystem>

namespace vug::delivery {

/// A binary .ply (turk1994): x, y, z, and each attribute with a type of its own: `int` of whole
/// numbers such as "id", `float` of others; "N" as nx, ny, nz, "Cd" as red, green, blue, other
/// vectors as NAME_0, NAME_1, NAME_2. Groups are left out. The file is whole or as it was.
/// Error(io).
void write_points(const volume::Points& points, const std::filesystem::path& file,
                  const mesh::Comments& notes);

}  // namespace vug::delivery
