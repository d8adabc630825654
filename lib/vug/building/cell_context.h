// What stands around cells, as attributes that recipes can name: computed only where one does.
#pragma once

#include <vug/base/progress.h>
#include <vug/cells/network.h>
#include <vug/mesh/mesh.h>

#include <string>
#include <vector>

namespace vug::building {

/// One of them for each cell; what stands around is the meshes.
std::vector<float> cell_context(const cells::Network& cells, const std::string& name,
                                const std::vector<mesh::MeshPtr>& meshes, Progress& progress);

}  // namespace vug::building
