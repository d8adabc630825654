// SPDX-License-Identifier: Apache-2.0
// Light with a measured distribution: a small sphere whose radiance in each direction is the
// measured intensity over its cross section.
#include <vug/base/maths.h>
#include <vug/render/kind.h>
#include <vug/render/lighting/ies_profile.h>
#include <vug/render/lighting/shape_light.h>
#include <vug/render/lighting/sphere_shape.h>
#include <vug/render/sampling.h>

namespace vug::render {
namespace {

struct Ies : LightOutputParams {
  std::filesystem::path file;
  Vec3d center{0, 0, 0};
  Vec3d direction{0, -1, 0};
  double turn = 0;
  double radius = 0.03;

  static void describe(Schema<Ies>& s) {
    s.doc("A small sphere light with a measured profile; radiance gives only the colour.")
        .cite("ies2002lm63")
        .param("file", &Ies::file, {.doc = "Profile, LM-63 type C.", .required = true})
        .param("center", &Ies::center, any_length("Centre."))
        .param("direction", &Ies::direction, {.doc = "Direction of the file's straight down."})
        .param("turn", &Ies::turn,
               {.doc = "Turns the profile about that direction.", .dimension = Dimension::angle})
        .param("radius", &Ies::radius,
               positive_length("Radius; a larger one makes softer shadows."));
    describe_light_output(s);
  }
  std::string fault() const {
    if (!is_direction(direction)) return "the light's direction must be finite and not zero";
    if (!(Vec3d(radiance).length() > 0))
      return "the light's radiance must be above 0, since it gives the colour";
    return LightOutputParams::fault();
  }
};

/// The profile divided by its peak.
struct MeasuredProfile {
  std::shared_ptr<const IesProfile> profile;
  Frame axes;
  float turn;

  float operator()(const Vec3f& direction) const {
    const Vec3f local = axes.to_local(direction);
    const double around = maths::atan2(static_cast<double>(local.y), static_cast<double>(local.x));
    return profile->candela(local.z, static_cast<float>(around / (2 * kPi)) - turn) /
           profile->peak();
  }
  float upper_bound(const Vec3f& direction, float ball) const {
    const float cosine = std::min(1.0f, dot(direction, axes.z));
    const float root = std::sqrt(std::max(0.0f, 1 - ball * ball));
    // Cosine of the angle to straight down, less the angle that the sphere subtends.
    const float nearest =
        cosine >= root ? 1 : cosine * root + std::sqrt(std::max(0.0f, 1 - cosine * cosine)) * ball;
    return nearest >= profile->lowest_cosine() ? std::max((*this)(direction), 0.05f) : 0;
  }
  void tighten(LightBounds& bounds) const {
    bounds.axis = axes.z;
    bounds.cos_spread = 1;
    bounds.cos_reach = profile->lowest_cosine();
  }
  /// Sets the uniform radiance of the same total power.
  void export_to(exchange::Light& light) const {
    light.place = exchange::look_along(light.place.origin(), Vec3d(axes.z), Vec3d(axes.y));
    light.radiance *= profile->lumen() / (4 * kPi * static_cast<double>(profile->peak()));
  }
};

class IesLight final : public ShapeLight<SphereShape, MeasuredProfile> {
 public:
  explicit IesLight(const Ies& p)
      : IesLight(p, std::make_shared<const IesProfile>(read_ies(p.file))) {}

 private:
  IesLight(const Ies& p, const std::shared_ptr<const IesProfile>& profile)
      : ShapeLight(SphereShape(p.center, p.radius), p, radiance(p, *profile),
                   {profile, Frame(Vec3f(p.direction.normalized())),
                    static_cast<float>(p.turn / (2 * kPi))}),
        file_(p.file) {}

  bool as_data(exchange::Light& light) const override {
    light.profile = file_;
    return ShapeLight::as_data(light);
  }

  static Rgb radiance(const Ies& p, const IesProfile& profile) {
    const Vec3d colour = p.tinted_radiance();
    const double scale = p.watts() ? *p.watts() * kLumenPerWatt / profile.lumen() : 1;
    const double intensity = static_cast<double>(profile.peak()) * scale / kLumenPerWatt;
    return finite_radiance(colour * (intensity / (kPi * p.radius * p.radius * luminance(colour))),
                           "the light is too small for its power");
  }

  std::filesystem::path file_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(ies, light, LightPtr, Ies, IesLight)
