// SPDX-License-Identifier: Apache-2.0
// Spotlight: a small sphere that emits into a cone with a smooth edge.
#include <vug/base/maths.h>
#include <vug/render/kind.h>
#include <vug/render/lighting/shape_light.h>
#include <vug/render/lighting/sphere_shape.h>

namespace vug::render {
namespace {

struct Spot : LightOutputParams {
  Vec3d center{0, 0, 0};
  Vec3d direction{0, -1, 0};
  double angle = 40 * kPi / 180;
  double edge = 0.3;
  double radius = 0.03;

  static void describe(Schema<Spot>& s) {
    s.doc("A small sphere that emits into a cone with a smooth edge.")
        .param("center", &Spot::center, any_length("Centre."))
        .param("direction", &Spot::direction, {.doc = "Axis of the cone."})
        .param("angle", &Spot::angle,
               {.doc = "Full angle of the cone.",
                .dimension = Dimension::angle,
                .min = 0,
                .max = 2 * kPi,
                .above_min = true})
        .param("edge", &Spot::edge,
               {.doc = "Fraction of the cone, inwards from its edge, in which the light fades.",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1})
        .param("radius", &Spot::radius,
               positive_length("Radius; a larger one makes softer shadows."));
    describe_light_output(s);
  }
  std::string fault() const {
    return is_direction(direction) ? LightOutputParams::fault()
                                   : "the spot's direction must be finite and not zero";
  }
  /// 1 - cosines of the cone, from its axis; the light fades from the inner to the outer angle.
  double outer() const { return off(0.5 * angle); }
  double inner() const { return off(0.5 * angle * (1 - edge)); }
  /// Intensity is the axial radiance times the sphere's cross section times the profile, whose
  /// integral over the smooth edge is half the edge's solid angle.
  double watts_per_radiance() const { return kPi * radius * radius * kPi * (inner() + outer()); }

 private:
  static double off(double angle) { return 2 * std::pow(maths::sin(0.5 * angle), 2); }
};

struct ConeProfile {
  Vec3f axis;
  float inner, outer;  ///< 1 - cosines, which stay accurate for narrow cones.

  float operator()(const Vec3f& direction) const {
    const Vec3f between = direction - axis;
    const float off = 0.5f * dot(between, between);
    if (off <= inner) return 1;
    if (off >= outer) return 0;
    const float t = (outer - off) / (outer - inner);
    return t * t * (3 - 2 * t);
  }
  float upper_bound(const Vec3f& direction, float ball) const {
    const float cosine = std::min(1.0f, dot(direction, axis));
    // Cosine of the angle to the axis, less the angle that the sphere subtends.
    const float root = std::sqrt(std::max(0.0f, 1 - ball * ball));
    const float nearest =
        cosine >= root ? 1 : cosine * root + std::sqrt(std::max(0.0f, 1 - cosine * cosine)) * ball;
    return nearest > 1 - outer - 1e-6f ? std::max((*this)(direction), 0.05f) : 0;
  }
  void tighten(LightBounds& bounds) const {
    bounds.axis = axis;
    bounds.cos_spread = 1;
    bounds.cos_reach = 1 - outer;
  }
  void export_to(exchange::Light& light) const {
    const double half = maths::acos(1 - static_cast<double>(outer));
    light.shape = exchange::Light::Shape::spot;
    light.place = exchange::look_along(light.place.origin(), Vec3d(axis));
    light.angle = 2 * half;
    light.edge = half > 0 ? 1 - maths::acos(1 - static_cast<double>(inner)) / half : 0;
  }
};

class SpotLight final : public ShapeLight<SphereShape, ConeProfile> {
 public:
  explicit SpotLight(const Spot& p)
      : ShapeLight(SphereShape(p.center, p.radius), p, p.radiance_for(p.watts_per_radiance()),
                   {Vec3f(p.direction.normalized()), static_cast<float>(p.inner()),
                    static_cast<float>(p.outer())}) {}
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(spot, light, LightPtr, Spot, SpotLight)
