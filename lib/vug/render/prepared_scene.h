// A scene made ready for rays: the acceleration structure and the choice of lights.
#pragma once

#include <vug/render/lighting/light_set.h>
#include <vug/render/media/medium.h>
#include <vug/render/scene.h>

#include <memory>
#include <vector>

namespace vug::render {

/// The nearest surface on a ray.
struct Hit {
  float distance = 0;
  const Material* material = nullptr;
  uint32_t object = kNoObject;
  uint32_t triangle = 0;
  Rgb emission{0, 0, 0};  ///< Radiance that the surface itself sends back along the ray.
  Surface surface;
  /// Where rays leave from, on the viewer's side: lifted to the smooth surface that vertex normals
  /// stand for, against shadow steps (Hanika 2021, "Hacking the shadow terminator",
  /// cite hanika2021terminator), and clear of the triangle itself.
  Vec3f origin;
  Vec3f behind;  ///< Where rays leave from that the surface lets through.
};

class PreparedScene {
 public:
  /// Keeps references into the scene's meshes. Throws as `render` does.
  explicit PreparedScene(const Scene& scene);
  /// The same surfaces under more lights.
  PreparedScene(const PreparedScene& other, const Scene& scene, const std::vector<LightPtr>& more);
  ~PreparedScene();
  PreparedScene(const PreparedScene&) = delete;
  PreparedScene& operator=(const PreparedScene&) = delete;
  /// Where all is at a time from 0, as the shutter opens, to 1, as it closes; shares everything.
  /// Without this it is the middle of that time.
  PreparedScene at(float time) const { return PreparedScene(*this, time); }
  /// Whether that makes a difference.
  bool moves() const;

  /// False when nothing is hit.
  bool intersect(const Ray& ray, Hit& hit) const {
    return intersect(ray, hit, [] {});
  }
  /// Does `meanwhile`, too, while what is known of the surface is on its way from memory.
  template <class Work>
  bool intersect(const Ray& ray, Hit& hit, const Work& meanwhile) const {
    const auto work = [](const void* what) { (*static_cast<const Work*>(what))(); };
    return intersect(ray, hit, work, &meanwhile);
  }
  /// True when a surface lies on the ray before `distance`.
  bool occluded(const Ray& ray, float distance) const;
  const Box3f& bounds() const;

  const LightSet& lights() const { return *lights_; }

  const Medium* medium() const { return medium_.get(); }

 private:
  struct Geometry;
  PreparedScene(const PreparedScene& other, float time);
  bool intersect(const Ray& ray, Hit& hit, void (*work)(const void*), const void* what) const;

  std::shared_ptr<const Geometry> geometry_;
  std::shared_ptr<const LightSet> lights_;
  MediumPtr medium_;
  float time_ = 0.5f;
};

}  // namespace vug::render
