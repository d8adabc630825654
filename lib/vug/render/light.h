// SPDX-License-Identifier: Apache-2.0
// Interface of lights. Lights do not block rays: a ray that hits one adds its emission and
// continues, so that a light is visible through others in every renderer alike.
#pragma once

#include <vug/render/vectors.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vug::exchange {
struct Light;
}

namespace vug::render {

/// Index of an object in a scene.
inline constexpr uint32_t kNoObject = ~0u;

/// A point to be lit: on a surface (its shading normal; light arrives only from that side) or in a
/// medium (normal zero).
struct LightSampleContext {
  Vec3f position;
  Vec3f normal{0, 0, 0};
  uint32_t object = kNoObject;  ///< The object that the surface belongs to.

  bool on_surface() const { return normal.x != 0 || normal.y != 0 || normal.z != 0; }
};

struct LightSample {
  Vec3f direction{0, 0, 0};  ///< Unit, from the point towards the light.
  float distance = 0;        ///< To the light; kFar for infinite lights.
  Rgb radiance{0, 0, 0};
  float pdf = 0;  ///< Per solid angle at the point; 0: nothing was sampled.
};

/// Emission that a ray collects where it hits a light.
struct LightHit {
  float distance = 0;
  Rgb radiance{0, 0, 0};
};

/// Position, orientation and power of a finite light, for the light tree.
struct LightBounds {
  Box3f box;
  Vec3f axis{0, 0, 1};    ///< Unit; axis of the cone of normals.
  float cos_spread = -1;  ///< Cosine of the half-angle of that cone.
  float cos_reach = 0;    ///< Cosine of the largest angle between a normal and emitted light.
  float strength = 0;     ///< Luminance times area, in W/sr.
};

/// Light linking and the light group, as given in the scene.
struct LightLinking {
  std::string group;  ///< For the AOVs of light groups; empty: none.
  /// Names of objects; both empty: it lights all objects. "a" also matches "a/b".
  std::vector<std::string> only, except;
};

class Light {
 public:
  explicit Light(LightLinking linking = {}) : linking_(std::move(linking)) {}
  virtual ~Light() = default;
  const LightLinking& linking() const { return linking_; }

  /// Samples a direction towards the light.
  virtual LightSample sample(const LightSampleContext& point, const Vec2f& u) const = 0;
  /// Density with which `sample` chooses `direction`; 0 where it never does.
  virtual float pdf(const LightSampleContext& point, const Vec3f& direction) const = 0;
  /// Approximate contribution at the point (power over squared distance). It is 0 only where the
  /// light cannot contribute, or where BSDF sampling is the better strategy.
  virtual float importance(const LightSampleContext& point) const = 0;
  /// The importance for all points of a ray between two distances.
  virtual float importance_along(const Ray& ray, float begin, float end) const = 0;
  /// Bounds of a finite light; not called for infinite lights.
  virtual LightBounds bounds() const { return {}; }
  /// Centre for equiangular sampling in media; meaningless for infinite lights.
  virtual Vec3f center() const { return {0, 0, 0}; }

  /// Computes the emission that a ray hits before `max_distance`; false without a hit. Not called
  /// for infinite lights.
  virtual bool intersect(const Ray& ray, float max_distance, LightHit& hit) const {
    (void)ray, (void)max_distance, (void)hit;
    return false;
  }
  virtual bool camera_visible() const { return true; }

  /// True for infinite lights: environments, and portals, which only mark where the environment is
  /// visible. Their samples have a distance of kFar and no radiance of their own: the radiance from
  /// a direction is the sum of `eval_environment` over all environments.
  virtual bool is_infinite() const { return false; }
  virtual bool is_portal() const { return false; }
  /// Mean over all directions; scales the importance of portals relative to finite lights.
  virtual float mean_luminance() const { return 0; }
  virtual Rgb eval_environment(const Vec3f& direction) const {
    (void)direction;
    return {0, 0, 0};
  }
  /// True for an environment that portals would hardly sample, such as the sun: it is sampled in
  /// addition to them.
  virtual bool sampled_with_portals() const { return false; }

  /// Fills in the description for exporters, except its name; false if the light has no equivalent
  /// there.
  virtual bool as_data(exchange::Light& light) const { return (void)light, false; }

 private:
  LightLinking linking_;
};
using LightPtr = std::shared_ptr<const Light>;

}  // namespace vug::render
