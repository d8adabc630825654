// SPDX-License-Identifier: Apache-2.0
// The walls of surveyed passages as meshes of a survey, which Loch's .lox files store.
#pragma once

#include <vug/mesh/mesh.h>
#include <vug/survey/survey.h>

#include <vector>

namespace vug::passages {

/// The connected components of a surface that are the walls around the stations of a survey: those
/// that are nearest to a station underground or to the end of a splay. The outside of a block of
/// rock and caves without a survey are therefore left out. The surface is in scene space, in which
/// `origin` (survey space) is 0; the scraps are in survey space, with their corners in the order
/// of the mesh. Throws Error(bad_input) for a surface without triangles.
std::vector<survey::Scrap> wall_scraps(const mesh::Mesh& surface, const survey::Survey& survey,
                                       const Vec3d& origin);

}  // namespace vug::passages
