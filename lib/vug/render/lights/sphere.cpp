// A ball that shines outwards.
#include <vug/render/lighting/sphere_shape.h>
#include <vug/render/kind.h>
#include <vug/render/lighting/shape_light.h>

namespace vug::render {
namespace {

struct Sphere : LampParams {
  Vec3d center{0, 0, 0};
  double radius = 0.1;

  static void describe(Schema<Sphere>& s) {
    s.doc("A ball that shines outwards; it does not block light.")
        .cite("shirley1996direct")
        .param("center", &Sphere::center, any_length("Its middle."))
        .param("radius", &Sphere::radius, positive_length("Its radius."));
    describe_lamp(s);
  }
};

class SphereLight final : public ShapeLamp<Ball> {
 public:
  explicit SphereLight(const Sphere& p)
      : ShapeLamp(Ball(p.center, p.radius), p, p.radiance_of(4 * kPi * kPi * p.radius * p.radius)) {
  }
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(sphere, light, LightPtr, Sphere, SphereLight)
