#include <vug/render/paths/direct.h>
#include <vug/render/tally.h>

namespace vug::render {
namespace {

Rgb light_from(const World& world, const LightChoice& chosen, const Hit& hit,
               const GuidedBsdf& bsdf, const Frame& frame, const PathVertex& vertex, const Vec2f& u,
               TrackingNumbers& numbers, Tally* tally) {
  const LightSample s = world.lights().sample(chosen.light, vertex.point, u);
  const bool behind = !(dot(s.direction, hit.surface.geometric_normal) > 0);
  if (!(s.pdf > 0) || (behind && vertex.point.on_surface())) return Rgb(0.0f);
  const Vec3f in = frame.to_local(s.direction);
  if (behind ? !(in.z < 0) : !(in.z > 0)) return Rgb(0.0f);
  const Scattering scattering = bsdf.evaluate(in, s.direction);
  const Rgb f = scattering.total();
  const Rgb light = unshadowed(world, s, hit.object);
  const Ray ray{behind ? hit.behind : hit.origin, s.direction};
  if (is_black(f) || is_black(light) || shadowed(world, ray, s.distance)) return Rgb(0.0f);
  const float direct = s.distance == kFar
                           ? world.lights().sky_pdf(vertex.point, vertex.odds, s.direction)
                           : chosen.probability * s.pdf;
  const float density = direct + scattering.pdf;
  if (!(density > 0)) return Rgb(0.0f);
  const float weight = clear_part(world, ray, s.distance, numbers) / density;
  if (tally && s.distance == kFar)
    tally->note_sky(world, hit.object, s.direction, f * weight, scattering.diffuse * weight);
  else if (tally)
    tally->note(world.lights().group(chosen.light), f * light * weight,
                scattering.diffuse * light * weight);
  return f * light * weight;
}

}  // namespace

Rgb direct_light(const World& world, const Hit& hit, const GuidedBsdf& bsdf, const Frame& frame,
                 PathVertex& vertex, float choice, const Vec2f& u, TrackingNumbers& numbers,
                 Tally* tally) {
  Rgb sum(0.0f);
  for (const LightChoice& chosen : world.lights().choose(vertex.point, choice, vertex.odds))
    sum += light_from(world, chosen, hit, bsdf, frame, vertex, u, numbers, tally);
  return sum;
}

}  // namespace vug::render
