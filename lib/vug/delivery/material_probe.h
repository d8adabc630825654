// What an object's material says of places on its mesh, seen from outside.
#pragma once

#include <vug/exchange/look.h>
#include <vug/render/scene.h>

#include <cstdint>
#include <vector>

namespace vug::delivery {

/// Keeps the object, which it is made of, by reference.
class MaterialProbe {
 public:
  explicit MaterialProbe(const render::Object& object);

  /// At a vertex; its opacity is 1 where the material has no holes.
  exchange::Look at(size_t vertex) const;
  /// On a triangle: `u` and `v` are the shares of its second and third corner.
  double opacity(size_t triangle, float u, float v) const;

 private:
  render::Surface surface(const Vec3f& position, const Vec3f& normal, const Vec3f& color) const;
  Vec3f color_of(size_t vertex) const;
  const std::vector<Vec3f>& normals() const {
    return mesh_.normals.empty() ? normals_ : mesh_.normals;
  }

  const render::Object& object_;
  const mesh::Mesh& mesh_;
  std::vector<uint32_t> corners_;  ///< A triangle of each vertex, as triangle * 3 + corner.
  std::vector<Vec3f> normals_;     ///< Where the mesh has none.
  const mesh::Attribute* color_;
  const render::InstanceTransform* instance_ = nullptr;  ///< That the look depends on.
};

}  // namespace vug::delivery
