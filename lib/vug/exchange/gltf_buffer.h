// SPDX-License-Identifier: Apache-2.0
// Internal to exchange/: the binary buffer of a glTF file with its views and accessors.
#pragma once

#include <vug/exchange/assembly.h>

#include <tiny_gltf.h>

#include <functional>
#include <string>
#include <vector>

namespace vug::exchange {

class GltfBuffer {
 public:
  explicit GltfBuffer(tinygltf::Model& model);

  /// Adds an accessor for `count` tuples of `arity` numbers. `bounds` is for positions.
  int floats(const float* values, size_t count, int arity, bool bounds, int target);
  int indices(const std::vector<mesh::Triangle>& triangles, size_t vertices);
  /// Adds vertex colours with opacity, clamped to 0..1 and stored with 16 bits each: steps of
  /// 1/65535. Without opacities the opacity is 1.
  int colors(const std::vector<float>& rgb, const std::vector<float>* opacity);

  /// Throws Error(too_large) if the file's 32-bit lengths do not suffice.
  void require_size(size_t bytes) const;

 private:
  int view(const void* data, size_t bytes, int target);
  int accessor(int view, int component, int type, size_t count);

  tinygltf::Model& model_;
};

/// A mesh with one primitive for each look: that of the prototype, or those of its rocks, whose
/// primitives share the vertices. `material_of` yields the number of the material of a look; names
/// of attributes that the mesh cannot hold are added to `unsupported`.
tinygltf::Mesh gltf_mesh(const Prototype& prototype,
                         const std::function<int(const Prototype&)>& material_of,
                         GltfBuffer& buffer, std::vector<std::string>& unsupported);

}  // namespace vug::exchange
