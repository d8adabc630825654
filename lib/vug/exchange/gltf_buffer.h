// Inside exchange/ only: the parts of a glTF file that hold numbers, the one buffer and what
// points into it.
#pragma once

#include <vug/exchange/assembly.h>

#include <tiny_gltf.h>

#include <string>
#include <vector>

namespace vug::exchange {

class GltfBuffer {
 public:
  explicit GltfBuffer(tinygltf::Model& model);

  /// The accessor of so many tuples of `arity` numbers. Bounds are those of positions.
  int floats(const float* values, size_t count, int arity, bool bounds, int target);
  int indices(const std::vector<mesh::Triangle>& triangles, size_t vertices);
  /// Red, green, blue and opacity of so many vertices, within 0..1 in 16 bits each: a step of
  /// 1/65535. Without opacities all is there.
  int colors(const std::vector<float>& rgb, const std::vector<float>* opacity);

  /// Error(too_large) where the file's lengths of 32 bits do not suffice.
  void require_size(size_t bytes) const;

 private:
  int view(const void* data, size_t bytes, int target);
  int accessor(int view, int component, int type, size_t count);

  tinygltf::Model& model_;
};

/// A mesh with one primitive; names of attributes that it cannot hold go to `unsupported`.
tinygltf::Mesh gltf_mesh(const Prototype& prototype, int material, GltfBuffer& buffer,
                         std::vector<std::string>& unsupported);

}  // namespace vug::exchange
