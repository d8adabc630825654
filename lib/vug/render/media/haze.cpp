// SPDX-License-Identifier: Apache-2.0
// Homogeneous haze in a box, with the Henyey-Greenstein phase function.
#include <vug/base/maths.h>
#include <vug/render/kind.h>
#include <vug/render/media/phase.h>

namespace vug::render {
namespace {

/// ln 50: the contrast of a black target against the haze is 2 % at the visibility (Koschmieder
/// 1924, cite koschmieder1924; the threshold of the visual range).
constexpr double kVisibility = 3.912;

struct Haze {
  double extinction = 0.02;
  std::optional<double> visibility;
  Vec3d albedo{0.9, 0.9, 0.9};
  double g = 0.6;
  Vec3d center{0, 0, 0};
  std::optional<Vec3d> size;

  static void describe(Schema<Haze>& s) {
    s.doc("Homogeneous haze, in a box or in the bounds of the scene's meshes.")
        .cite("henyey1941")
        .param("extinction", &Haze::extinction,
               {.doc = "Extinction coefficient (1/m); 0.005 to 0.05 in a cave.",
                .dimension = Dimension::per_length,
                .min = 0})
        .param(
            "visibility", &Haze::visibility,
            positive_length("Distance at which dark objects fade to 2 % of contrast, in place of "
                            "the extinction: it is 3.912 divided by this (Koschmieder)."))
        .param("albedo", &Haze::albedo,
               {.doc = "Fraction of the collisions that scatter.", .min = 0, .max = 1})
        .param("g", &Haze::g,
               {.doc = "Mean cosine of scattering; above 0 is forward scattering.",
                .min = -0.99,
                .max = 0.99})
        .param("center", &Haze::center, any_length("Centre of the box."))
        .param("size", &Haze::size,
               positive_length("Size of the box; the scene's own box when not given."));
  }
};

class HazeMedium final : public Medium {
 public:
  explicit HazeMedium(const Haze& p)
      : extinction_(static_cast<float>(p.visibility ? kVisibility / *p.visibility : p.extinction)),
        albedo_(p.albedo),
        g_(static_cast<float>(p.g)),
        bounded_(p.size.has_value()) {
    if (p.size) box_ = {Vec3f(p.center - *p.size * 0.5), Vec3f(p.center + *p.size * 0.5)};
  }

  MediumPtr with_bounds(const Box3f& scene) const override {
    if (bounded_) return nullptr;
    auto copy = std::make_shared<HazeMedium>(*this);
    copy->box_ = scene;
    copy->bounded_ = true;
    return copy;
  }

  Segment clip(const Ray& ray, float end) const override {
    return bounded_ ? clip_to_box(box_, ray, end) : Segment{0, end};
  }
  float transmittance(const Ray&, const Segment& segment, TrackingRng&) const override {
    return segment.empty() ? 1 : attenuation(segment.end - segment.begin);
  }
  DistanceSample sample_distance(const Ray&, const Segment& segment, float u,
                                 std::span<ScatterPoint> scatter_points,
                                 TrackingRng&) const override {
    for (ScatterPoint& point : scatter_points)
      point.transmittance = attenuation(point.distance - segment.begin);
    if (segment.empty() || !(extinction_ > 0)) return {};
    const double t = -maths::log(1 - static_cast<double>(u)) / static_cast<double>(extinction_);
    const float distance = segment.begin + static_cast<float>(t);
    return {distance, distance < segment.end};
  }
  float extinction(const Vec3f&) const override { return extinction_; }
  Rgb albedo(const Vec3f&) const override { return albedo_; }

  float typical_extinction() const override { return extinction_; }

  float phase(float cosine) const override { return henyey_greenstein(g_, cosine); }
  Vec3f sample_phase(const Vec3f& travel, const Vec2f& u) const override {
    return sample_henyey_greenstein(g_, travel, u);
  }

 private:
  float attenuation(float distance) const {
    return static_cast<float>(
        maths::exp(-static_cast<double>(extinction_) * static_cast<double>(distance)));
  }

  float extinction_;
  Rgb albedo_;
  float g_;
  bool bounded_;
  Box3f box_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(haze, medium, MediumPtr, Haze, HazeMedium)
