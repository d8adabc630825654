// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/base/quantile.h>
#include <vug/image/brightness.h>
#include <vug/scout/illumination.h>
#include <vug/scout/trace_view.h>

#include <algorithm>
#include <cmath>

namespace vug::scout {
namespace {

constexpr float kPixelBlack = 0.004f;
constexpr float kJump = 1.3f;               // ratio of the distances at an edge
constexpr float kContrast = 4;              // ratio of the luminances at a silhouette
constexpr float kVisible = 0.04f;           // exposed luminance of what is behind a silhouette
constexpr double kEnoughSilhouettes = 0.5;  // of the width
constexpr double kFlat = 0.7;               // factor of a picture without silhouettes

Vec2f two(RandomStream& random) {
  const auto u = static_cast<float>(random.uniform());
  return {std::min(u, 0.9999999f), std::min(static_cast<float>(random.uniform()), 0.9999999f)};
}

/// Irradiance of the finite lights and the suns on a surface.
float direct_irradiance(const render::PreparedScene& world,
                        const std::vector<render::LightPtr>& lights, const Seen& at,
                        RandomStream& random) {
  float sum = 0;
  for (const render::LightPtr& light : lights) {
    if (light->is_portal() || (light->is_infinite() && !light->sampled_with_portals())) continue;
    const render::LightSample sample =
        light->sample({at.origin, at.normal, at.object}, two(random));
    const float cosine = render::dot(sample.direction, at.normal);
    if (!(sample.pdf > 0) || !(cosine > 0)) continue;
    const render::Rgb radiance =
        light->is_infinite() ? light->eval_environment(sample.direction) : sample.radiance;
    const float arrives = render::luminance(radiance) * cosine / sample.pdf;
    if (arrives > 0 && !world.occluded({at.origin, sample.direction}, sample.distance))
      sum += arrives;
  }
  return sum;
}

float sky_radiance(const std::vector<render::LightPtr>& lights, const Vec3f& direction) {
  float sum = 0;
  for (const render::LightPtr& light : lights)
    if (light->is_infinite() && !light->is_portal() && !light->sampled_with_portals())
      sum += render::luminance(light->eval_environment(direction));
  return sum;
}

Vec3f cosine_direction(const Vec3f& normal, const Vec2f& u) {
  const double radius = std::sqrt(static_cast<double>(u.x));
  const double angle = 2 * kPi * static_cast<double>(u.y);
  const Vec3f local(static_cast<float>(radius * maths::cos(angle)),
                    static_cast<float>(radius * maths::sin(angle)), std::sqrt(1 - u.x));
  return render::Frame(normal).to_world(local);
}

/// Radiance of the surface towards the eye.
float radiance_of(const render::PreparedScene& world, const std::vector<render::LightPtr>& lights,
                  const Seen& seen, int rays, RandomStream& random) {
  if (seen.object == kSky) return 0;
  float light = direct_irradiance(world, lights, seen, random) / render::kPif;
  for (int i = 0; i < rays; ++i) {
    const Vec3f way = cosine_direction(seen.normal, two(random));
    const Seen next = look_along(world, Vec3d(seen.origin), Vec3d(way));
    const float reflected =
        next.object == kSky ? sky_radiance(lights, way)
                            : next.emission + next.albedo / render::kPif *
                                                  direct_irradiance(world, lights, next, random);
    light += reflected / static_cast<float>(rays);
  }
  return seen.emission + seen.albedo * light;
}

/// The number of pairs of neighbours of which the nearer is a silhouette in front of the other.
/// The sky counts as bright.
size_t silhouette_edges(const View& view, const std::vector<float>& luminance, float factor) {
  const auto is_edge = [&](size_t a, size_t b) {
    if (view.pixels[a].distance > view.pixels[b].distance) std::swap(a, b);
    if (view.pixels[b].object == kSky) return luminance[a] * factor < kVisible / kContrast;
    return view.pixels[b].distance > kJump * view.pixels[a].distance &&
           luminance[b] * factor > kVisible && luminance[b] > kContrast * luminance[a];
  };
  size_t edges = 0;
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      if (x + 1 < view.width && is_edge(view.index(x, y), view.index(x + 1, y))) ++edges;
      if (y + 1 < view.height && is_edge(view.index(x, y), view.index(x, y + 1))) ++edges;
    }
  return edges;
}

}  // namespace

std::vector<float> illuminate(const render::PreparedScene& world,
                              const std::vector<render::LightPtr>& lights, const View& view,
                              RandomKey key, const IlluminationOptions& options) {
  std::vector<float> out(view.pixels.size(), 0);
  parallel_for(
      out.size(),
      [&](size_t i) {
        RandomStream random(key.at(i));
        out[i] = radiance_of(world, lights, view.pixels[i], options.rays, random);
      },
      64);
  return out;
}

double LightTerms::total() const {
  if (bright < 0.02) return 0;
  const double seen = std::min(1.0, silhouettes / kEnoughSilhouettes);
  return std::clamp((0.85 - black) / 0.35, 0.0, 1.0) * (kFlat + (1 - kFlat) * seen);
}

image::Image grey_picture(const std::vector<float>& luminance) {
  image::Image out(static_cast<int>(luminance.size()), 1, {"R", "G", "B"});
  for (size_t i = 0; i < luminance.size(); ++i)
    for (size_t c = 0; c < 3; ++c) out.pixels[3 * i + c] = luminance[i];
  return out;
}

LightTerms light_terms(const std::vector<float>& luminance, const View& view) {
  LightTerms terms;
  const std::optional<double> stops = image::metered_exposure(grey_picture(luminance));
  if (!stops) return terms;
  terms.stops = *stops;
  const auto factor = static_cast<float>(std::exp2(*stops));
  const auto dark = std::count_if(luminance.begin(), luminance.end(),
                                  [&](float value) { return value * factor < kPixelBlack; });
  terms.black = static_cast<double>(dark) / static_cast<double>(luminance.size());
  terms.bright = static_cast<double>(quantile(luminance, 0.99) * factor);
  terms.silhouettes = static_cast<double>(silhouette_edges(view, luminance, factor)) / view.width;
  return terms;
}

}  // namespace vug::scout
