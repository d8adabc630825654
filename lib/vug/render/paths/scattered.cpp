#include <vug/base/maths.h>
#include <vug/render/paths/direct.h>
#include <vug/render/tally.h>

#include <algorithm>

namespace vug::render {
namespace {

Rgb scattered_from(const World& world, const LightChoice& chosen, const Ray& ray,
                   const Segment& segment, float where, const Vec2f& u, TrackingNumbers& numbers,
                   Tally* tally) {
  const Medium& medium = *world.medium();
  // Distances from the foot of the perpendicular, which equiangular sampling is about.
  const Vec3f to = world.lights().centre(chosen.light) - ray.origin;
  const float foot = dot(to, ray.direction);
  const auto height = static_cast<double>(
      std::max(length(to - ray.direction * foot), 1e-4f * (segment.end - segment.begin)));
  const double a = static_cast<double>(segment.begin - foot),
               b = static_cast<double>(segment.end - foot);
  const double angle_a = maths::atan2(a, height), angle_b = maths::atan2(b, height);
  const double optical = static_cast<double>(medium.usual_extinction());
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

  const LitPoint point{ray.at(distance), Vec3f(0.0f)};
  const float extinction = medium.extinction(point.position);
  if (!(extinction > 0)) return Rgb(0.0f);
  const LightSample s = world.lights().sample(chosen.light, point, u);
  if (!(s.pdf > 0) || !(density > 0)) return Rgb(0.0f);
  const Rgb light = unshadowed(world, s, kNoObject);
  const Ray shadow{point.position, s.direction};
  if (is_black(light) || shadowed(world, shadow, s.distance)) return Rgb(0.0f);
  // Portals that share a direction share its light.
  float sharing = 1;
  if (s.distance == kFar) {
    sharing = 0;
    for (const LightId sky : world.lights().sampled_skies())
      if (sky == chosen.light || world.lights().pdf(sky, point, s.direction) > 0) sharing += 1;
  }
  const float pdf = chosen.probability * s.pdf * sharing;
  const float scattered = medium.extinction(point.position) *
                          medium.phase(dot(ray.direction, s.direction)) *
                          medium.transmittance(ray, {segment.begin, distance}, numbers) *
                          clear_part(world, shadow, s.distance, numbers);
  const Rgb weight = medium.albedo(point.position) * (scattered / (pdf * density));
  if (tally && s.distance == kFar)
    tally->note_sky(world, kNoObject, s.direction, weight);
  else if (tally)
    tally->note(world.lights().group(chosen.light), light * weight);
  return light * weight;
}

}  // namespace

Rgb scattered_light(const World& world, const Ray& ray, const Segment& segment, float samples,
                    const Chances& sight, float choice, float where, const Vec2f& u,
                    TrackingNumbers& numbers, Tally* tally) {
  Rgb sum(0.0f);
  for (const LightChoice& chosen :
       world.lights().choose_along(ray, segment, choice, samples, sight))
    sum += scattered_from(world, chosen, ray, segment, where, u, numbers, tally);
  return sum;
}

}  // namespace vug::render
