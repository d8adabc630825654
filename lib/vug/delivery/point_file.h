// SPDX-License-Identifier: Apache-2.0
// Writes points as a mesh file without triangles, for programs that cannot read points in .vdb
// files.
#pragma once

#include <vug/mesh/comments.h>
#include <vug/volume/points.h>

#include <filesystem>

namespace vug::delivery {

/// Writes a binary .ply (turk1994) with x, y, z and all attributes: `int` for integers such as
/// "id", `float` for others; "N" as nx, ny, nz, "Cd" as red, green, blue, other vectors as NAME_0,
/// NAME_1, NAME_2. Groups are omitted. The file is written completely or left unchanged. Error(io).
void write_points(const volume::Points& points, const std::filesystem::path& file,
                  const mesh::Comments& notes);

}  // namespace vug::delivery
