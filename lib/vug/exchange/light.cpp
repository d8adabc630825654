// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/exchange/camera.h>
#include <vug/exchange/light.h>

namespace vug::exchange {

Transform look_along(const Vec3d& from, const Vec3d& along, const Vec3d& up) {
  const Vec3d z = -along.normalized();
  Vec3d x = up.cross(z);
  if (!(x.length() > 1e-6 * up.length())) x = Vec3d(0, 0, 1).cross(z);
  if (!(x.length() > 1e-6)) x = Vec3d(1, 0, 0).cross(z);
  x.normalize();
  return {x, z.cross(x), z, from};
}

double focal_length(const Camera& camera) {
  return 0.5 * kFilmWidth / maths::tan(0.5 * camera.fov);
}

Vec3d peak_intensity(const Light& light) {
  switch (light.shape) {
    case Light::Shape::rectangle:
      return light.radiance * (light.width * light.height);
    case Light::Shape::sun: {
      // The integral of the cosine over the disk.
      const double sine = maths::sin(0.5 * light.angle);
      return light.radiance * (kPi * sine * sine);
    }
    case Light::Shape::dome:
      return light.radiance;
    default:
      return light.radiance * (kPi * light.radius * light.radius);
  }
}

Vec3d power(const Light& light) {
  switch (light.shape) {
    case Light::Shape::sphere:
      return peak_intensity(light) * (4 * kPi);
    case Light::Shape::spot: {
      // Light fades smoothly between the two cones: half of the region in between counts.
      const double outer = maths::cos(0.5 * light.angle);
      const double inner = maths::cos(0.5 * light.angle * (1 - light.edge));
      return peak_intensity(light) * (kPi * (2 - inner - outer));
    }
    case Light::Shape::rectangle:
    case Light::Shape::disk:
      return peak_intensity(light) * kPi;
    default:
      return Vec3d(0.0);
  }
}

}  // namespace vug::exchange
