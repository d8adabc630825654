// SPDX-License-Identifier: Apache-2.0
// Sun: an infinitely distant disk, in the same direction from every point.
#include <vug/base/maths.h>
#include <vug/exchange/light.h>
#include <vug/render/kind.h>
#include <vug/render/lighting/light_output.h>
#include <vug/render/lighting/sun_position.h>
#include <vug/render/sampling.h>

namespace vug::render {
namespace {

struct Sun : SunParams, LightLinking {
  double angle = 0.533 * kPi / 180;
  double turbidity = 3;
  std::optional<Vec3d> irradiance;

  static void describe(Schema<Sun>& s) {
    s.doc("The sun, or any round light infinitely far away.").cite("preetham1999");
    describe_sun(s);
    s.param("angle", &Sun::angle,
            {.doc = "Angular diameter; a larger one makes softer shadows.",
             .dimension = Dimension::angle,
             .min = 0.0005,
             .max = kPi})
        .param("turbidity", &Sun::turbidity,
               {.doc = "Turbidity of the air that its light passes: 2 clear, 10 hazy.",
                .min = 1,
                .max = 20})
        .param("irradiance", &Sun::irradiance,
               {.doc = "Irradiance (W/m^2) of a surface that faces it; replaces the value from the "
                       "turbidity.",
                .dimension = Dimension::irradiance,
                .min = 0});
    describe_linking(s);
  }
};

class SunLight final : public Light {
 public:
  explicit SunLight(const Sun& p) : Light(linking_of(p)), axes_(Vec3f(p.direction())) {
    const double cosine = maths::cos(p.angle / 2), sine = maths::sin(p.angle / 2);
    part_ = static_cast<float>(sine * sine / (1 + cosine));
    const Vec3d irradiance = p.irradiance.value_or(sun_irradiance(p.direction(), p.turbidity));
    // The integral of the cosine over the disk is pi sin^2.
    radiance_ = finite_radiance(irradiance / (kPi * sine * sine));
    strength_ = luminance(Rgb(irradiance));
    sine_ = static_cast<float>(sine);
  }

  LightSample sample(const LightSampleContext&, const Vec2f& u) const override {
    LightSample s;
    s.direction = axes_.to_world(direction_off_axis(u.x * part_, u.y));
    s.distance = kFar;
    s.pdf = 1 / (2 * kPif * part_);
    return s;
  }
  float pdf(const LightSampleContext&, const Vec3f& direction) const override {
    return inside(direction) ? 1 / (2 * kPif * part_) : 0;
  }
  float importance(const LightSampleContext& point) const override {
    if (!point.on_surface()) return strength_;
    const float cosine = dot(point.normal, axes_.z);
    return cosine > -sine_ ? strength_ * std::max(cosine, 0.02f) : 0;
  }
  float importance_along(const Ray&, float begin, float end) const override {
    return strength_ * (end - begin);
  }
  bool is_infinite() const override { return true; }
  bool sampled_with_portals() const override { return true; }
  float mean_luminance() const override { return luminance(radiance_) * 0.5f * part_; }
  Rgb eval_environment(const Vec3f& direction) const override {
    return inside(direction) ? radiance_ : Rgb(0.0f);
  }
  bool as_data(exchange::Light& light) const override {
    light.shape = exchange::Light::Shape::sun;
    light.place = exchange::look_along(Vec3d(0.0), -Vec3d(axes_.z));
    light.radiance = Vec3d(radiance_);
    light.angle = 2 * maths::atan2(static_cast<double>(sine_), 1 - static_cast<double>(part_));
    return true;
  }

 private:
  /// Uses the distance from the axis, which avoids cancellation at small angles.
  bool inside(const Vec3f& direction) const {
    const float along = dot(direction, axes_.z);
    const Vec3f off = direction - axes_.z * along;
    return part_ >= 1 ? along >= 1 - part_ : along > 0 && dot(off, off) <= sine_ * sine_;
  }

  Frame axes_;
  float part_, strength_, sine_;  ///< 1 - cos and sin of half the angle.
  Rgb radiance_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(sun, light, LightPtr, Sun, SunLight)
