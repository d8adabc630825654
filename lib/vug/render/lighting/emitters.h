// Meshes that shine: every triangle is a light. Those that shine evenly cost no memory of their
// own, others a number for the tree.
#pragma once

#include <vug/render/lighting/light_tree.h>
#include <vug/render/scene.h>

#include <vector>

namespace vug::render {

/// Triangles shine from their front, with the radiance of their object and that of its material at
/// the place, exactly; only for the tree is a material's averaged over a few places. Nearby they
/// are sampled by solid angle (Arvo 1995, "Stratified sampling of spherical triangles", cite
/// arvo1995triangle), from afar by area, which is as good there and cheaper.
class Emitters {
 public:
  Emitters() = default;
  explicit Emitters(const std::vector<Object>& objects);

  size_t size() const { return count_; }
  /// Some shine by their material: ask for the radiance where a ray meets them.
  bool emission_varies() const { return emission_varies_; }
  /// At a place on the front of a triangle, shares of its second and third corner; `footprint` as
  /// in Surface. Black for a triangle that does not shine.
  Rgb radiance(uint32_t index, float u, float v, float footprint) const;
  /// Number of a triangle of an object that shines; ~0 for any other.
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
    PlacingPtr placing;
    bool looks_by_place = false;
    MaterialPtr material = nullptr;  ///< If it shines; then also:
    std::shared_ptr<const field::SampledGrid> solid = nullptr;
    bool flat = false;
    std::vector<float> luminances = {};  ///< Of each triangle, about: means over some places.
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
  std::vector<uint32_t> first_;  ///< Of each object; kNone for those that do not shine.
};

}  // namespace vug::render
