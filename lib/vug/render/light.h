// The seam of lights. Lamps do not block rays: a ray that meets one gathers its light and goes
// on, so that the same lamp shines through its neighbours in every renderer alike.
#pragma once

#include <vug/render/vectors.h>

#include <memory>

namespace vug::render {

/// A point that asks for light: on a surface (normal of unit length, light arrives from the
/// normal's side only) or in a medium (normal zero).
struct LitPoint {
  Vec3f position;
  Vec3f normal{0, 0, 0};

  bool on_surface() const { return normal.x != 0 || normal.y != 0 || normal.z != 0; }
};

struct LightSample {
  Vec3f direction;     ///< Unit, from the point towards the light.
  float distance = 0;  ///< To the light; kFar for the sky.
  Rgb radiance{0, 0, 0};
  float pdf = 0;  ///< Over solid angle at the point; 0 means: nothing was sampled.
};

/// What a ray gathers where it meets a light.
struct LightHit {
  float distance = 0;
  Rgb radiance{0, 0, 0};
};

class Light {
 public:
  virtual ~Light() = default;

  /// Chooses a direction towards the light.
  virtual LightSample sample(const LitPoint& point, const Vec2f& u) const = 0;
  /// Density with which `sample` chooses `direction`, 0 where it never does.
  virtual float pdf(const LitPoint& point, const Vec3f& direction) const = 0;
  /// How much this light may matter at the point (power over distance squared, about); 0 only
  /// where it cannot matter or is better found by following the material's own directions.
  virtual float importance(const LitPoint& point) const = 0;

  /// Emission met by a ray before `max_distance`; false for none. Not called for skies.
  virtual bool intersect(const Ray& ray, float max_distance, LightHit& hit) const {
    (void)ray, (void)max_distance, (void)hit;
    return false;
  }
  /// Skies only: radiance that arrives against `direction` from infinitely far.
  virtual Rgb escape_radiance(const Vec3f& direction) const {
    (void)direction;
    return {0, 0, 0};
  }
  /// True when the light lies infinitely far away all round.
  virtual bool is_sky() const { return false; }
  virtual bool camera_visible() const { return true; }
  /// The place that equiangular sampling in a medium turns to; meaningless for skies.
  virtual Vec3f centre() const { return {0, 0, 0}; }
};
using LightPtr = std::shared_ptr<const Light>;

}  // namespace vug::render
