// Next-event estimation: light that is chosen instead of found.
#pragma once

#include <vug/render/paths/guided.h>
#include <vug/render/paths/vertex.h>

#include <array>
#include <span>

namespace vug::render {

/// Direct light at a surface, scattered towards the viewer, by as many shadow rays as
/// `vertex.selection` asks for samples. A few times as many lights are weighed for it by what they
/// would give if nothing stood in between (resampled importance sampling: Talbot, Cline, Egbert
/// 2005, "Importance resampling for global illumination", cite talbot2005resampling); the odds are
/// told how these were chosen, by which rays that meet a light are weighed. `choice`: of lights to
/// weigh, and of those that get a ray. `tally` may be null.
Rgb direct_light(const World& world, const Hit& hit, const GuidedBsdf& bsdf, const Frame& frame,
                 PathVertex& vertex, const Vec2f& choice, const Vec2f& u, TrackingRng& numbers,
                 Tally* tally);

/// Light that is scattered once into a ray, anywhere in a segment of the medium. The places are
/// chosen about each lamp by equiangular sampling (Kulla and Fajardo 2012, "Importance sampling
/// techniques for path tracing in participating media", kulla2012media) or by the medium itself,
/// half and half. Of the lights that the odds choose those in sight are kept.
class ScatteredLight {
 public:
  ScatteredLight(const World& world, const Ray& ray, const Segment& segment,
                 const LightSelection& selection, const VisibilityCache& visibility, float choice,
                 float where, const Vec2f& u, TrackingRng& numbers);

  /// Where it is scattered; to be told what comes through to there.
  std::span<ScatterPoint> scatter_points() { return {scatter_points_.data(), size_}; }
  /// As it comes to the ray's origin, once the marks are told. `tally` may be null.
  Rgb arriving(Tally* tally) const;

 private:
  struct Source {
    LightId light;
    Vec3f direction;
    bool sky;
    Rgb radiance, weight;
  };
  void add(const LightChoice& chosen, const Ray& ray, const Segment& segment, float where,
           const Vec2f& u, TrackingRng& numbers);

  const World& world_;
  std::array<ScatterPoint, LightChoices::kMax> scatter_points_;
  std::array<Source, LightChoices::kMax> sources_;
  size_t size_ = 0;
};

}  // namespace vug::render
