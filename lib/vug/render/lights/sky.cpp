// SPDX-License-Identifier: Apache-2.0
// Sky of constant radiance. No direction is better than another, so it samples none itself; BSDF
// sampling and portals find it.
#include <vug/exchange/light.h>
#include <vug/render/kind.h>
#include <vug/render/lighting/light_output.h>

namespace vug::render {
namespace {

struct Sky : LightLinking {
  Vec3d radiance{1, 1, 1};

  static void describe(Schema<Sky>& s) {
    s.doc("A sky of one colour in all directions.")
        .param("radiance", &Sky::radiance,
               {.doc = "Radiance of red, green, blue in W/sr/m^2.", .min = 0});
    describe_linking(s);
  }
};

class SkyLight final : public Light {
 public:
  explicit SkyLight(const Sky& p) : Light(linking_of(p)), radiance_(finite_radiance(p.radiance)) {}

  LightSample sample(const LightSampleContext&, const Vec2f&) const override { return {}; }
  float pdf(const LightSampleContext&, const Vec3f&) const override { return 0; }
  float importance(const LightSampleContext&) const override { return 0; }
  float importance_along(const Ray&, float, float) const override { return 0; }
  bool is_infinite() const override { return true; }
  float mean_luminance() const override { return luminance(radiance_); }
  Rgb eval_environment(const Vec3f&) const override { return radiance_; }
  bool as_data(exchange::Light& light) const override {
    light.shape = exchange::Light::Shape::dome;
    light.radiance = Vec3d(radiance_);
    return true;
  }

 private:
  Rgb radiance_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(sky, light, LightPtr, Sky, SkyLight)
