// SPDX-License-Identifier: Apache-2.0
// Subsurface scattering by a random walk through the medium inside a body, from the point of entry
// to the point of exit.
#pragma once

#include <vug/base/rng.h>
#include <vug/render/prepared_scene.h>

namespace vug::render {

/// Random numbers of a walk, seeded by unique values.
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

/// Beer-Lambert transmittance.
Rgb beer_lambert(const Rgb& absorption, float distance);

/// Walks from `hit` in an inward direction until a face of the same object is hit from inside.
/// `hit` then is that point, seen from outside, and `throughput` is reduced by absorption. Returns
/// false if no light exits: it is absorbed, or another object inside the body is hit, which counts
/// as black. Where the body is open the medium continues to the bounds of the scene, which absorb.
/// Surfaces are only searched within each free path, which is short compared with the scene.
bool random_walk_subsurface(const PreparedScene& world, const SubsurfaceMedium& medium,
                            const Vec3f& direction, RandomStream& random, Hit& hit,
                            Rgb& throughput);

}  // namespace vug::render
