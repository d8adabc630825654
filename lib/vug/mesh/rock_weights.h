// SPDX-License-Identifier: Apache-2.0
// The weights of rock materials as vertex attributes, and the material of each triangle.
#pragma once

#include <vug/mesh/mesh.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vug::mesh {

/// The attribute and the grid with the weights of a material: "w_limestone".
std::string weight_attribute(std::string_view material);

/// The material of an attribute of weights; nothing for other attributes.
std::optional<std::string> material_of_attribute(std::string_view attribute);

/// The materials whose weights the mesh has, ordered by name.
std::vector<std::string> rock_materials(const Mesh& mesh);

/// For each triangle the index in `materials` of the largest sum of weights at its corners; of
/// equal sums the first. -1 where all weights are 0. Materials without an attribute have weight 0.
std::vector<int32_t> face_materials(const Mesh& mesh, const std::vector<std::string>& materials);

}  // namespace vug::mesh
