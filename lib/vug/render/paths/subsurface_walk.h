// Light beneath a surface: a random walk through the cloud that fills a body, from where light
// goes in to where it comes out.
#pragma once

#include <vug/base/rng.h>
#include <vug/render/prepared_scene.h>

namespace vug::render {

/// Numbers of a walk that begins with these, of no use to anyone else.
inline RandomStream subsurface_random(const Vec2f& u, float lobe) {
  const auto bits = [](float x) { return static_cast<uint64_t>(x * 0x1p24f); };
  return RandomStream(RandomKey(bits(u.x) << 24 | bits(u.y)).at(bits(lobe)));
}
inline float next_float(RandomStream& random) {
  return static_cast<float>(random.bits() >> 8) * 0x1p-24f;
}
inline Vec2f next_pair(RandomStream& random) {
  const float x = next_float(random);
  return {x, next_float(random)};
}

/// Beer's law.
Rgb beer_lambert(const Rgb& absorption, float distance);

/// Walks from `hit` in a direction that leads in, until a face of the same object is met from
/// within. Then `hit` is that place, seen from outside, and `throughput` has lost what collisions
/// swallowed. False when nothing comes out: all was swallowed, the body is open, or another
/// object stands in it, which is taken as black. Steps are short against the scene, so that
/// nearly all of the time goes into rays.
bool random_walk_subsurface(const World& world, const SubsurfaceMedium& medium,
                            const Vec3f& direction, RandomStream& random, Hit& hit,
                            Rgb& throughput);

}  // namespace vug::render
