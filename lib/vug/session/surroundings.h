// What stands around cells, as attributes that recipes can name: computed only where one does.
#pragma once

#include <vug/base/progress.h>
#include <vug/cells/network.h>
#include <vug/mesh/mesh.h>

#include <string>
#include <vector>

namespace vug::session {

/// exposure: the light of an even sky as a share of what falls on open level ground; occlusion: the
/// share of the directions above a cell in which rock stands within 50 cm, weighted by cosines;
/// curvature: the mean of the surface's, by how normals turn from a cell to its neighbours, in 1/m:
/// 1/r on a ball, below 0 in hollows. It needs no level set, as the masks cavity and edge do.
const std::vector<std::string>& surroundings();

/// One of them for each cell; what stands around is the meshes.
std::vector<float> surroundings_of(const cells::Network& cells, const std::string& name,
                                   const std::vector<mesh::MeshPtr>& meshes, Progress& progress);

}  // namespace vug::session
