// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/render/paths/subsurface_walk.h>
#include <vug/render/sampling.h>

namespace vug::render {
namespace {

/// Long walks are subject to Russian roulette; none is cut off, so the estimate is unbiased.
constexpr int kSureSteps = 32;
/// Surfaces are searched up to this multiple of the free path, because the distance of a hit, which
/// decides, has fewer rounding errors than the search.
constexpr float kBeyond = 1.001f;
constexpr int kMostSteps = 100000;  // limit for bodies that absorb nothing

/// The same point from the other side.
void flip(Hit& hit) {
  Surface& surface = hit.surface;
  surface.geometric_normal = -surface.geometric_normal;
  surface.shading_normal = -surface.shading_normal;
  surface.inside = !surface.inside;
  std::swap(hit.origin, hit.behind);
}

}  // namespace

Rgb beer_lambert(const Rgb& absorption, float distance) {
  if (is_black(absorption)) return Rgb(1.0f);
  Rgb clear;
  for (int c = 0; c < 3; ++c)
    clear[c] = static_cast<float>(maths::exp(-static_cast<double>(absorption[c] * distance)));
  return clear;
}

bool random_walk_subsurface(const PreparedScene& world, const SubsurfaceMedium& medium,
                            const Vec3f& direction, RandomStream& random, Hit& hit,
                            Rgb& throughput) {
  const uint32_t object = hit.object;
  Ray ray{hit.behind, direction};
  for (int step = 0; step < kMostSteps; ++step) {
    const auto free = static_cast<float>(-maths::log(1 - random.uniform())) * medium.mean_free_path;
    if (world.intersect(ray, free * kBeyond, hit) && hit.distance <= free) {
      if (hit.object != object || !hit.surface.inside) return false;
      flip(hit);
      return true;
    }
    throughput *= medium.albedo;
    if (step >= kSureSteps) {
      const float survival = std::min(1.0f, largest(throughput));
      if (!(next_float(random) < survival)) return false;
      throughput *= 1 / survival;
    }
    ray = {ray.at(free), sample_sphere(next_pair(random))};
    if (!world.bounds().intersects(ray.origin)) return false;
  }
  return false;
}

}  // namespace vug::render
