// SPDX-License-Identifier: Apache-2.0
// Light that scatters once in a medium along a segment of a path.
#include <vug/base/maths.h>
#include <vug/render/film/light_path_recorder.h>
#include <vug/render/paths/direct.h>

#include <algorithm>

namespace vug::render {

ScatteredLight::ScatteredLight(const PreparedScene& world, const Ray& ray, const Segment& segment,
                               const LightSelection& selection, const VisibilityCache& visibility,
                               const LightRandom& random)
    : world_(world) {
  for (const LightChoice& chosen :
       world.lights().choose_along(ray, segment, random.choice.x, selection, visibility))
    add(chosen, ray, segment, random);
}

void ScatteredLight::add(const LightChoice& chosen, const Ray& ray, const Segment& segment,
                         const LightRandom& random) {
  const float where = random.choice.y;
  const Medium& medium = *world_.medium();
  // Distances are relative to the foot of the perpendicular, the origin of equiangular sampling.
  const Vec3f to = world_.lights().center(chosen.light) - ray.origin;
  const float foot = dot(to, ray.direction);
  const auto height = static_cast<double>(
      std::max(length(to - ray.direction * foot), 1e-4f * (segment.end - segment.begin)));
  const double a = static_cast<double>(segment.begin - foot),
               b = static_cast<double>(segment.end - foot);
  const double angle_a = maths::atan2(a, height), angle_b = maths::atan2(b, height);
  const double optical = static_cast<double>(medium.typical_extinction());
  const double span = b - a;
  const double through = 1 - maths::exp(-optical * span);
  double t = 0;
  if (where < 0.5f) {
    t = height * maths::tan(angle_a + 2 * static_cast<double>(where) * (angle_b - angle_a));
  } else {
    const double v = 2 * static_cast<double>(where) - 1;
    t = a + (through > 1e-6 ? -maths::log(1 - v * through) / optical : v * span);
  }
  t = std::clamp(t, a, b);
  const double equiangular = height / ((angle_b - angle_a) * (height * height + t * t));
  const double falling =
      through > 1e-6 ? optical * maths::exp(-optical * (t - a)) / through : 1 / span;
  const auto density = static_cast<float>(0.5 * (equiangular + falling));
  const float distance = static_cast<float>(t) + foot;

  const LightSampleContext point{ray.at(distance), Vec3f(0.0f)};
  medium.prefetch(point.position);
  const LightSample s = world_.lights().sample(chosen.light, point, random.u);
  if (!(s.pdf > 0) || !(density > 0)) return;
  const Rgb light = unoccluded_radiance(world_, s, kNoObject);
  const float extinction = medium.extinction(point.position);
  if (!(extinction > 0)) return;
  const Ray shadow{point.position, s.direction};
  if (is_black(light) || occluded(world_, shadow, s.distance)) return;
  // Suns and portals in the same direction share its light by the balance heuristic.
  float directions = s.pdf;
  if (s.distance == kFar)
    for (const LightId sky : world_.lights().sampled_skies())
      if (sky != chosen.light) directions += world_.lights().pdf(sky, point, s.direction);
  const float pdf = chosen.probability * directions;
  const float scattered = extinction * medium.phase(dot(ray.direction, s.direction)) *
                          transmittance(world_, shadow, s.distance, random.numbers);
  scatter_points_[size_] = {distance};
  sources_[size_++] = {chosen.light, s.direction, s.distance == kFar, light,
                       medium.albedo(point.position) * (scattered / (pdf * density))};
}

Rgb ScatteredLight::arriving(LightPathRecorder* recorder) const {
  Rgb sum(0.0f);
  for (size_t i = 0; i < size_; ++i) {
    const Source& from = sources_[i];
    const Rgb weight = from.weight * scatter_points_[i].transmittance,
              light = from.radiance * weight;
    if (recorder && from.sky)
      recorder->record_environment(world_, kNoObject, from.direction, weight);
    else if (recorder)
      recorder->record(world_.lights().group(from.light), light);
    sum += light;
  }
  return sum;
}

}  // namespace vug::render
