// SPDX-License-Identifier: Apache-2.0
// Attributes that describe the surroundings of cells, computed only if a rule or mask uses them.
#pragma once

#include <vug/base/progress.h>
#include <vug/cells/network.h>
#include <vug/mesh/mesh.h>

#include <string>
#include <vector>

namespace vug::building {

/// The attribute `name`, one of shot::context_attribute_names(), for each cell, with `meshes` as
/// occluders.
std::vector<float> cell_context(const cells::Network& cells, const std::string& name,
                                const std::vector<mesh::MeshPtr>& meshes, Progress& progress);

}  // namespace vug::building
