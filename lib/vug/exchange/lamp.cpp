#include <vug/base/maths.h>
#include <vug/exchange/camera.h>
#include <vug/exchange/lamp.h>

namespace vug::exchange {

Transform looking(const Vec3d& from, const Vec3d& along, const Vec3d& up) {
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

Vec3d strength(const Lamp& lamp) {
  switch (lamp.shape) {
    case Lamp::Shape::rectangle:
      return lamp.radiance * (lamp.width * lamp.height);
    case Lamp::Shape::sun: {
      // The integral of the cosine over the disk.
      const double sine = maths::sin(0.5 * lamp.angle);
      return lamp.radiance * (kPi * sine * sine);
    }
    case Lamp::Shape::dome:
      return lamp.radiance;
    default:
      return lamp.radiance * (kPi * lamp.radius * lamp.radius);
  }
}

Vec3d power(const Lamp& lamp) {
  switch (lamp.shape) {
    case Lamp::Shape::sphere:
      return strength(lamp) * (4 * kPi);
    case Lamp::Shape::spot: {
      // Light fades smoothly between the two cones: half of what lies between counts.
      const double outer = maths::cos(0.5 * lamp.angle);
      const double inner = maths::cos(0.5 * lamp.angle * (1 - lamp.edge));
      return strength(lamp) * (kPi * (2 - inner - outer));
    }
    case Lamp::Shape::rectangle:
    case Lamp::Shape::disk:
      return strength(lamp) * kPi;
    default:
      return Vec3d(0.0);
  }
}

}  // namespace vug::exchange
