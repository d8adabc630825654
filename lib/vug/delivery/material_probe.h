// SPDX-License-Identifier: Apache-2.0
// Evaluates an object's material at points of its mesh, viewed from outside.
#pragma once

#include <vug/exchange/look.h>
#include <vug/render/scene.h>

#include <cstdint>
#include <vector>

namespace vug::delivery {

/// Whether instances of the object can look different.
bool varies_by_instance(const render::Object& object);

/// Stores a reference to the object, which must outlive it.
class MaterialProbe {
 public:
  explicit MaterialProbe(const render::Object& object);

  /// The look at a vertex; the opacity is 1 if the material has no opacity mask.
  exchange::Look at(size_t vertex) const;
  /// The opacity on a triangle; `u` and `v` are the barycentric coordinates of its second and third
  /// corners.
  double opacity(size_t triangle, float u, float v) const;

 private:
  render::Surface surface(const Vec3f& position, const Vec3f& normal, const Vec3f& color) const;
  Vec3f color_of(size_t vertex) const;
  const std::vector<Vec3f>& normals() const {
    return mesh_.normals.empty() ? normals_ : mesh_.normals;
  }

  const render::Object& object_;
  const mesh::Mesh& mesh_;
  std::vector<uint32_t> corners_;  ///< A corner of each vertex, as triangle * 3 + corner.
  std::vector<Vec3f> normals_;     ///< Vertex normals if the mesh has none.
  const mesh::Attribute* color_;
  const render::InstanceTransform* instance_ = nullptr;  ///< Set if it determines the look.
};

}  // namespace vug::delivery
