// SPDX-License-Identifier: Apache-2.0
// Next-event estimation at surfaces and in media.
#pragma once

#include <vug/render/paths/guided.h>
#include <vug/render/paths/vertex.h>

#include <array>
#include <span>

namespace vug::render {

/// A surface that scatters light towards the viewer.
struct ScatteringSurface {
  const Hit& hit;
  const GuidedBsdf& bsdf;
  const Frame& frame;
};

/// Random numbers for sampling lights.
struct LightRandom {
  Vec2f choice;  ///< For the choice of candidates, and of those that get a ray or of the distance.
  Vec2f u;       ///< For the point on the light.
  TrackingRng& numbers;
};

/// Direct light at a surface, scattered towards the viewer, with as many shadow rays as
/// `vertex.selection` has samples. A few times as many candidate lights are weighted by their
/// unoccluded contribution (resampled importance sampling: Talbot, Cline, Egbert 2005, "Importance
/// resampling for global illumination", cite talbot2005resampling). The selection records how the
/// candidates were chosen, which sets the weights of rays that hit a light. `recorder` may be null.
Rgb direct_light(const PreparedScene& world, const ScatteringSurface& surface, PathVertex& vertex,
                 const LightRandom& random, LightPathRecorder* recorder);

/// Single scattering into a ray anywhere in a segment of the medium. Scatter points are sampled
/// about each light by equiangular sampling (Kulla and Fajardo 2012, "Importance sampling
/// techniques for path tracing in participating media", kulla2012media) or by the medium, with
/// equal probability. Of the lights chosen by the selection, the visible ones are kept.
class ScatteredLight {
 public:
  ScatteredLight(const PreparedScene& world, const Ray& ray, const Segment& segment,
                 const LightSelection& selection, const VisibilityCache& visibility,
                 const LightRandom& random);

  /// The points where light scatters; the caller sets their transmittance.
  std::span<ScatterPoint> scatter_points() { return {scatter_points_.data(), size_}; }
  /// Radiance at the ray's origin, after the transmittance has been set. `recorder` may be null.
  Rgb arriving(LightPathRecorder* recorder) const;

 private:
  struct Source {
    LightId light;
    Vec3f direction;
    bool sky;
    Rgb radiance, weight;
  };
  void add(const LightChoice& chosen, const Ray& ray, const Segment& segment,
           const LightRandom& random);

  const PreparedScene& world_;
  std::array<ScatterPoint, LightChoices::kMax> scatter_points_;
  std::array<Source, LightChoices::kMax> sources_;
  size_t size_ = 0;
};

}  // namespace vug::render
