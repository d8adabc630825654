// SPDX-License-Identifier: Apache-2.0
#include <vug/render/film/light_path_recorder.h>
#include <vug/render/paths/direct.h>

#include <algorithm>

namespace vug::render {
namespace {

/// Candidates for each shadow ray if a tree chooses the lights or the surface is glossy: weighting
/// them costs a fraction of a ray and considers the BSDF, the light's shape and its direction,
/// which the importance of lights does not. On matte surfaces a few lights are chosen well enough
/// by their importance.
constexpr float kCandidates = 3;
/// Fraction of the shadow rays distributed uniformly over the candidates, since the visibility
/// cache may be wrong.
constexpr float kEven = 0.05f;

/// Light that arrives unless it is occluded or attenuated.
struct LightCandidate {
  LightId from = kNoLight;
  Ray ray;
  float distance = 0;
  /// Scattered towards the viewer per unit of light, over the density; and its diffuse part.
  Rgb scattering{0, 0, 0}, diffuse{0, 0, 0};
  Rgb light{0, 0, 0};
  float weight = 0;  ///< Expected contribution of its shadow ray.
};

LightCandidate candidate(const PreparedScene& world, const LightChoice& chosen,
                         const ScatteringSurface& surface, const PathVertex& vertex,
                         const Vec2f& u) {
  const auto& [hit, bsdf, frame] = surface;
  const LightSample s = world.lights().sample(chosen.light, vertex.point, u);
  if (!(s.pdf > 0)) return {};
  // The side is that of the smooth surface, from which rays leave; the side of the triangle would
  // cut off grazing light.
  const Vec3f in = frame.to_local(s.direction);
  const bool behind = !(in.z > 0);
  if (behind && (vertex.point.on_surface() || dot(s.direction, hit.surface.geometric_normal) > 0))
    return {};
  const Scattering scattering = bsdf.evaluate(in, s.direction);
  const Rgb f = scattering.total();
  const Rgb light = unoccluded_radiance(world, s, hit.object);
  float density = chosen.probability * s.pdf + scattering.pdf;
  if (s.distance == kFar)
    density += world.lights().sky_pdf(vertex.point, vertex.selection, s.direction, chosen.light);
  if (is_black(f) || is_black(light) || !(density > 0)) return {};
  LightCandidate c{chosen.light, {behind ? hit.behind : hit.origin, s.direction}, s.distance};
  c.scattering = f * (1 / density), c.diffuse = scattering.diffuse * (1 / density);
  c.light = light;
  c.weight = luminance(c.scattering * light) * chosen.visibility;
  return c;
}

Rgb arriving(const PreparedScene& world, const LightCandidate& c, const Hit& hit, float probability,
             TrackingRng& numbers, LightPathRecorder* recorder) {
  if (occluded(world, c.ray, c.distance)) return Rgb(0.0f);
  const float part = transmittance(world, c.ray, c.distance, numbers) / probability;
  if (recorder && c.distance == kFar)
    recorder->record_environment(world, hit.object, c.ray.direction, c.scattering * part,
                                 c.diffuse * part);
  else if (recorder)
    recorder->record(world.lights().group(c.from), c.scattering * c.light * part,
                     c.diffuse * c.light * part);
  return c.scattering * c.light * part;
}

}  // namespace

Rgb direct_light(const PreparedScene& world, const ScatteringSurface& surface, PathVertex& vertex,
                 const LightRandom& random, LightPathRecorder* recorder) {
  const float rays = vertex.selection.samples;
  const LightSet& lights = world.lights();
  if (lights.branches() < lights.size() || (surface.bsdf.glossy() && lights.size() > 1))
    vertex.selection.samples = std::min(rays * kCandidates, static_cast<float>(LightChoices::kMax));
  std::array<LightCandidate, LightChoices::kMax> candidates;
  size_t size = 0;
  float all = 0;
  for (const LightChoice& chosen : lights.choose(vertex.point, random.choice.x, vertex.selection)) {
    candidates[size] = candidate(world, chosen, surface, vertex, random.u);
    if (candidates[size].weight > 0) all += candidates[size++].weight;
  }
  // Systematic sampling, as in the choice of lights.
  const auto count = static_cast<float>(size);
  const float proportional = rays * (1 - kEven) / all, even = rays * kEven / count;
  Rgb sum(0.0f);
  float passed = 0, tooth = random.choice.y;
  for (size_t i = 0; i < size; ++i) {
    const float probability =
        count <= rays ? 1 : std::min(1.0f, proportional * candidates[i].weight + even);
    passed += probability;
    if (!(tooth < passed)) continue;
    tooth += 1;
    sum += arriving(world, candidates[i], surface.hit, probability, random.numbers, recorder);
  }
  return sum;
}

}  // namespace vug::render
