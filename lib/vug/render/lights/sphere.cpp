// SPDX-License-Identifier: Apache-2.0
// Sphere light.
#include <vug/render/kind.h>
#include <vug/render/lighting/shape_light.h>
#include <vug/render/lighting/sphere_shape.h>

namespace vug::render {
namespace {

struct Sphere : LightOutputParams {
  Vec3d center{0, 0, 0};
  double radius = 0.1;

  static void describe(Schema<Sphere>& s) {
    s.doc("A sphere light that emits outwards; it does not block light.")
        .cite("shirley1996direct")
        .param("center", &Sphere::center, any_length("Centre."))
        .param("radius", &Sphere::radius, positive_length("Radius."));
    describe_light_output(s);
  }
};

class SphereLight final : public ShapeLight<SphereShape> {
 public:
  explicit SphereLight(const Sphere& p)
      : ShapeLight(SphereShape(p.center, p.radius), p,
                   p.radiance_for(4 * kPi * kPi * p.radius * p.radius)) {}
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(sphere, light, LightPtr, Sphere, SphereLight)
