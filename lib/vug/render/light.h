// The seam of lights. Lamps do not block rays: a ray that meets one gathers its light and goes
// on, so that the same lamp shines through its neighbours in every renderer alike.
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

/// A point that asks for light: on a surface (its shading normal, from whose side alone light
/// arrives) or in a medium (normal zero).
struct LightSampleContext {
  Vec3f position;
  Vec3f normal{0, 0, 0};
  uint32_t object = kNoObject;  ///< Whose surface it is.

  bool on_surface() const { return normal.x != 0 || normal.y != 0 || normal.z != 0; }
};

struct LightSample {
  Vec3f direction{0, 0, 0};  ///< Unit, from the point towards the light.
  float distance = 0;        ///< To the light; kFar for the sky.
  Rgb radiance{0, 0, 0};
  float pdf = 0;  ///< Over solid angle at the point; 0 means: nothing was sampled.
};

/// What a ray gathers where it meets a light.
struct LightHit {
  float distance = 0;
  Rgb radiance{0, 0, 0};
};

/// Where a lamp is, which way it shines and how strongly: what a tree of lights knows of it.
struct LightBounds {
  Box3f box;
  Vec3f axis{0, 0, 1};    ///< Unit; the lamp's normals all lie ...
  float cos_spread = -1;  ///< ... within the angle of this cosine from it, and
  float cos_reach = 0;    ///< light leaves at up to the angle of this cosine from a normal.
  float strength = 0;     ///< Luminance times area, in W/sr.
};

/// What a scene says of a light beside its shape and brightness.
struct LightLinking {
  std::string group;  ///< Of the picture's layers of lights; empty: none.
  /// Names of objects; both empty: it lights all. "a" means "a/b", too.
  std::vector<std::string> only, except;
};

class Light {
 public:
  explicit Light(LightLinking linking = {}) : linking_(std::move(linking)) {}
  virtual ~Light() = default;
  const LightLinking& linking() const { return linking_; }

  /// Chooses a direction towards the light.
  virtual LightSample sample(const LightSampleContext& point, const Vec2f& u) const = 0;
  /// Density with which `sample` chooses `direction`, 0 where it never does.
  virtual float pdf(const LightSampleContext& point, const Vec3f& direction) const = 0;
  /// How much this light may matter at the point (power over distance squared, about); 0 only
  /// where it cannot matter, or where following the material's own directions finds it better.
  virtual float importance(const LightSampleContext& point) const = 0;
  /// The same for all points of a ray between two distances, together.
  virtual float importance_along(const Ray& ray, float begin, float end) const = 0;
  /// Bounds of a lamp; never asked of skies.
  virtual LightBounds bounds() const { return {}; }
  /// The place that equiangular sampling in a medium turns to; meaningless for whole skies.
  virtual Vec3f center() const { return {0, 0, 0}; }

  /// Emission met by a ray before `max_distance`; false for none. Not called for skies.
  virtual bool intersect(const Ray& ray, float max_distance, LightHit& hit) const {
    (void)ray, (void)max_distance, (void)hit;
    return false;
  }
  virtual bool camera_visible() const { return true; }

  /// True when its light comes from infinitely far: skies, and portals, which only tell where the
  /// sky can be seen. Their samples carry a distance of kFar and no radiance of their own: what
  /// arrives from a direction is the sum of all skies' `eval_environment`.
  virtual bool is_infinite() const { return false; }
  virtual bool is_portal() const { return false; }
  /// Over all directions; times it the importance of portals stands against that of lamps.
  virtual float mean_luminance() const { return 0; }
  virtual Rgb eval_environment(const Vec3f& direction) const {
    (void)direction;
    return {0, 0, 0};
  }
  /// A sky that portals would hardly find, as the sun: it is sampled beside them.
  virtual bool sampled_with_portals() const { return false; }

  /// Fills in what files of other programs are told of it, but for its name; false where they have
  /// no word for it.
  virtual bool as_data(exchange::Light& light) const { return (void)light, false; }

 private:
  LightLinking linking_;
};
using LightPtr = std::shared_ptr<const Light>;

}  // namespace vug::render
