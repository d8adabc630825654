// SPDX-License-Identifier: Apache-2.0
// The result of the preparation for ray tracing: acceleration structures and light selection.
#pragma once

#include <vug/render/lighting/light_set.h>
#include <vug/render/media/medium.h>
#include <vug/render/scene.h>

#include <memory>
#include <vector>

namespace vug::render {

/// The closest surface on a ray.
struct Hit {
  float distance = 0;
  const Material* material = nullptr;
  uint32_t object = kNoObject;
  uint32_t triangle = 0;
  Rgb emission{0, 0, 0};  ///< Radiance that the surface emits back along the ray.
  Surface surface;
  /// Origin for rays on the viewer's side: lifted to the smooth surface implied by the vertex
  /// normals, against the shadow terminator (Hanika 2021, "Hacking the shadow terminator",
  /// cite hanika2021terminator), and clear of the triangle itself.
  Vec3f origin;
  Vec3f behind;  ///< Origin for rays that are transmitted through the surface.
};

/// The numbers of trees (BVHs) of a scene: one of all triangles in world space, one of all that is
/// traced with Embree, and one of each shape that has instances.
struct TreeCounts {
  size_t built = 0;
  size_t reused = 0;  ///< Shared with another scene.
};

class PreparedScene {
 public:
  /// Keeps references to the scene's meshes. `before`: a version of the scene, whose trees are
  /// shared as far as they contain the same shapes; may be null. The scene does not depend on it.
  /// Throws as `render` does.
  explicit PreparedScene(const Scene& scene, const PreparedScene* before = nullptr);
  /// Shares the geometry of `other` and adds lights.
  PreparedScene(const PreparedScene& other, const Scene& scene, const std::vector<LightPtr>& more);
  ~PreparedScene();
  PreparedScene(const PreparedScene&) = delete;
  PreparedScene& operator=(const PreparedScene&) = delete;
  /// The scene at a time from 0 (shutter opens) to 1 (shutter closes); shares all data. Without
  /// this it is the scene in the middle of the exposure.
  PreparedScene at(float time) const { return PreparedScene(*this, time); }
  /// True if `at` makes a difference.
  bool moves() const;
  /// The trees that the construction built and shared.
  const TreeCounts& trees() const;

  /// False if nothing is hit.
  bool intersect(const Ray& ray, Hit& hit) const {
    return intersect(ray, hit, [] {});
  }
  /// The same for surfaces before `distance`, up to rounding: a short search is much faster.
  bool intersect(const Ray& ray, float distance, Hit& hit) const {
    return intersect(
        ray, distance, hit, [](const void*) {}, nullptr);
  }
  /// Also runs `meanwhile` while the data of the surface is fetched from memory.
  template <class Work>
  bool intersect(const Ray& ray, Hit& hit, const Work& meanwhile) const {
    const auto work = [](const void* what) { (*static_cast<const Work*>(what))(); };
    return intersect(ray, kFar, hit, work, &meanwhile);
  }
  /// True if a surface blocks the ray before `distance`.
  bool occluded(const Ray& ray, float distance) const;
  const Box3f& bounds() const;

  const LightSet& lights() const { return *lights_; }

  const Medium* medium() const { return medium_.get(); }

 private:
  struct Geometry;
  PreparedScene(const PreparedScene& other, float time);
  bool intersect(const Ray& ray, float distance, Hit& hit, void (*work)(const void*),
                 const void* what) const;

  std::shared_ptr<const Geometry> geometry_;
  std::shared_ptr<const LightSet> lights_;
  MediumPtr medium_;
  float time_ = 0.5f;
};

}  // namespace vug::render
