// SPDX-License-Identifier: Apache-2.0
// The triangles at each vertex of a mesh.
#pragma once

#include <vug/mesh/mesh.h>

#include <span>

namespace vug::mesh {

class Fans {
 public:
  explicit Fans(const Mesh& mesh);

  /// The triangles that have a corner at the vertex, ascending.
  std::span<const uint32_t> at(uint32_t vertex) const {
    return {faces_.data() + first_[vertex], faces_.data() + first_[vertex + 1]};
  }

 private:
  std::vector<uint32_t> first_, faces_;
};

}  // namespace vug::mesh
