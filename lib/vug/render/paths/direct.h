// Next-event estimation: light that is chosen instead of found.
#pragma once

#include <vug/render/paths/guided.h>
#include <vug/render/paths/vertex.h>

namespace vug::render {

/// Direct light at a surface, scattered towards the viewer, by as many lights as `vertex.odds` asks
/// for; the odds are told the rest. `tally` may be null.
Rgb direct_light(const World& world, const Hit& hit, const GuidedBsdf& bsdf, const Frame& frame,
                 PathVertex& vertex, float choice, const Vec2f& u, TrackingNumbers& numbers,
                 Tally* tally);

/// Light that is scattered once into the ray, anywhere in a segment of the medium, weighed by the
/// clear part of the way back to the ray's origin. The place is chosen about each lamp by
/// equiangular sampling (Kulla and Fajardo 2012, "Importance sampling techniques for path tracing
/// in participating media", kulla2012media) or by the medium itself, half and half. At most
/// `samples` lights.
Rgb scattered_light(const World& world, const Ray& ray, const Segment& segment, float samples,
                    const Chances& sight, float choice, float where, const Vec2f& u,
                    TrackingNumbers& numbers, Tally* tally);

}  // namespace vug::render
