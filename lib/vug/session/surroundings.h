// What stands around cells, as attributes that recipes can name: computed only where one does.
#pragma once

#include <vug/base/progress.h>
#include <vug/cells/network.h>
#include <vug/mesh/mesh.h>

#include <string>
#include <vector>

namespace vug::session {

/// exposure: the light of an even sky as a share of what falls on open level ground; occlusion: the
/// share of the directions above a cell in which rock stands within 50 cm, weighted by cosines.
const std::vector<std::string>& surroundings();

/// One of them for each cell; what stands around is the meshes.
std::vector<float> surroundings_of(const cells::Network& cells, const std::string& name,
                                   const std::vector<mesh::MeshPtr>& meshes, Progress& progress);

}  // namespace vug::session
