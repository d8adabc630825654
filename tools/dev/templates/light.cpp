//@ lib/vug/render/lights
// SPDX-License-Identifier: Apache-2.0
// STUB: the shape of the light, the sampling of directions towards it, and the source.
#include <vug/render/kind.h>
#include <vug/render/sampling.h>

namespace vug::render {
namespace {

struct NewKind {
  Vec3d radiance{1, 1, 1};

  static void describe(Schema<NewKind>& s) {
    s.doc("STUB: the light, in one sentence.")
        .param("radiance", &NewKind::radiance,
               {.doc = "Radiance of red, green, blue in W/sr/m^2.", .min = 0});
  }
};

/// A sky that samples all directions uniformly. See Light for the contract of each function.
class NewKindLight final : public Light {
 public:
  explicit NewKindLight(const NewKind& p) : radiance_(p.radiance) {}

  LightSample sample(const LightSampleContext&, const Vec2f& u) const override {
    LightSample s;
    s.direction = sample_sphere(u);
    s.distance = kFar;
    s.pdf = kDensity;
    return s;
  }
  float pdf(const LightSampleContext&, const Vec3f&) const override { return kDensity; }
  float importance(const LightSampleContext&) const override { return luminance(radiance_); }
  float importance_along(const Ray&, float begin, float end) const override {
    return luminance(radiance_) * (end - begin);
  }
  bool is_infinite() const override { return true; }
  Rgb eval_environment(const Vec3f&) const override { return radiance_; }

 private:
  static constexpr float kDensity = 1 / (4 * kPif);
  Rgb radiance_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(new_kind, light, LightPtr, NewKind, NewKindLight)
