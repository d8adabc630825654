// Paths that look where light comes from without gathering any.
#pragma once

#include <vug/render/guiding/guide.h>
#include <vug/render/guiding/radiance_cache.h>
#include <vug/render/sampler.h>
#include <vug/render/world.h>

namespace vug::render {

/// Follows a camera ray over at most `bounces` surfaces, led by `guide` (null: none), and tells
/// `training` at each how bright the next one is. The medium is passed over.
void explore(const World& world, const Ray& camera_ray, SampleCursor& numbers, int bounces,
             const Guide* guide, const RadianceCache& brightness, GuideTraining& training);

}  // namespace vug::render
