// SPDX-License-Identifier: Apache-2.0
// Emissive meshes: every triangle is a light. Triangles of uniform emission need no memory of their
// own; the others store one number for the light tree.
#pragma once

#include <vug/render/lighting/light_tree.h>
#include <vug/render/scene.h>

#include <vector>

namespace vug::render {

/// Triangles emit from their front face. Their radiance is that of the object plus the exact
/// emission of its material at the point; only the light tree uses the material's average over a
/// few points. Triangles are sampled by solid angle nearby (Arvo 1995, "Stratified sampling of
/// spherical triangles", cite arvo1995triangle) and by area from afar, where area sampling is as
/// good and cheaper.
class Emitters {
 public:
  Emitters() = default;
  explicit Emitters(const std::vector<Object>& objects);

  size_t size() const { return count_; }
  /// Some triangles have an emissive material, so the radiance must be evaluated at the hit point.
  bool emission_varies() const { return emission_varies_; }
  /// Radiance at a point on the front of a triangle; u and v are the barycentric coordinates of its
  /// second and third vertex, `footprint` is as in Surface. Black for a triangle that is not
  /// emissive.
  Rgb radiance(uint32_t index, float u, float v, float footprint) const;
  /// Index of an emissive triangle of an object; ~0 for any other triangle.
  uint32_t index_of(uint32_t object, uint32_t triangle) const {
    return object < first_.size() && first_[object] != kNone ? first_[object] + triangle : kNone;
  }
  uint32_t object(uint32_t index) const { return emissive_mesh(index).object; }

  LightBounds bounds(uint32_t index) const;
  Vec3f center(uint32_t index) const;
  LightSample sample(uint32_t index, const LightSampleContext& point, const Vec2f& u) const;
  float pdf(uint32_t index, const LightSampleContext& point, const Vec3f& direction) const;

 private:
  static constexpr uint32_t kNone = ~0u;
  struct EmissiveMesh {
    mesh::MeshPtr mesh;
    Rgb radiance;
    uint32_t object, first;
    InstanceTransformPtr instance;
    bool world_space_material = false;
    MaterialPtr material =
        nullptr;  ///< Null unless it is emissive; then the members below are set, too.
    std::shared_ptr<const field::SampledGrid> solid = nullptr;
    bool flat = false;
    std::vector<float> luminances =
        {};  ///< Approximate luminance of each triangle: means over a few points.
  };
  struct WorldTriangle;
  const EmissiveMesh& emissive_mesh(uint32_t index) const;
  Rgb radiance_at(const EmissiveMesh& source, uint32_t triangle, float u, float v,
                  float footprint) const;
  void estimate_luminances(EmissiveMesh& source) const;
  WorldTriangle world_triangle(uint32_t index) const;

  size_t count_ = 0;
  bool emission_varies_ = false;
  std::vector<EmissiveMesh> sources_;
  std::vector<uint32_t> first_;  ///< For each object its first index; kNone if it is not emissive.
};

}  // namespace vug::render
