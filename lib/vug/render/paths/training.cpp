#include <vug/base/parallel.h>
#include <vug/render/camera.h>
#include <vug/render/paths/training.h>
#include <vug/render/paths/vertex.h>
#include <vug/render/sampling.h>
#include <vug/raytree/path_scheduler.h>
#include <vug/render/prepared_scene.h>

#include <algorithm>
#include <array>

namespace vug::render {
namespace {

constexpr uint64_t kSalt = 0x6775696465ull;

/// Rounds of gathering, each with twice the paths of the one before and led by it: what few paths
/// come to by chance, many come to in the next.
constexpr int kRounds = 3;
constexpr size_t kChunk = 256;
/// Glances are taken from so many places for each path of a round, evenly over all sightings.
constexpr double kPlaces = 0.5;
/// From each at so many lights.
constexpr size_t kLightsAtOnce = 4;
/// Edge of the regions that share what they see of lights, and how bright they are: see Regions.
constexpr float kRegion = 1.0f / 32;

constexpr uint32_t kNothing = ~0u;

/// Without those that looked at nothing.
std::vector<Glance> taken(std::vector<Glance> glances) {
  glances.erase(std::remove_if(glances.begin(), glances.end(),
                               [](const Glance& glance) { return glance.at == kNothing; }),
                glances.end());
  return glances;
}

/// What `paths` camera rays all over the picture see, in their order.
void watch(const Rehearsal& rehearsal, size_t paths, uint64_t salt, const Learned& learned,
           const TrailedPath& gather, Progress& progress, std::vector<Sighting>& sightings) {
  std::vector<std::vector<Sighting>> chunks((paths + kChunk - 1) / kChunk);
  parallel_for(chunks.size(), [&](size_t chunk) {
    progress.check();
    std::array<std::vector<Sighting>, kMostAhead> seen;
    const size_t begin = chunk * kChunk;
    work_together(
        std::min(paths - begin, kChunk),
        [&](size_t i) {
          SampleCursor numbers(rehearsal.sampler,
                               rehearsal.sample_id(kSalt + salt, begin + i, paths));
          const Vec2f film = numbers.pair(), lens = numbers.pair();
          Trail trail(seen[i % kMostAhead]);
          gather(rehearsal.camera.ray(film, rehearsal.aspect, lens), numbers, learned, trail);
        },
        [&](size_t i) {
          std::vector<Sighting>& path = seen[i % kMostAhead];
          chunks[chunk].insert(chunks[chunk].end(), path.begin(), path.end());
          path.clear();
        });
  });
  for (const std::vector<Sighting>& chunk : chunks)
    sightings.insert(sightings.end(), chunk.begin(), chunk.end());
}

/// Looks from places that paths came to at patches: half of the time at one that would light the
/// place, half at any, since what is thought to be hidden may be seen from here.
std::vector<Glance> glance_about(const Rehearsal& rehearsal, size_t most, uint64_t salt,
                                 const Guide& guide, const std::vector<Sighting>& sightings,
                                 Progress& progress) {
  const size_t step = std::max<size_t>(1, sightings.size() / std::max<size_t>(most, 1));
  const size_t places = sightings.size() / step;
  const std::vector<BrightPatch>& patches = guide.patches();
  std::vector<Glance> glances(2 * places, Glance{{0, 0, 0}, kNothing, false});
  parallel_together(places, [&](size_t place) {
    progress.check();
    const Sighting& at = sightings[place * step];
    SampleCursor numbers(rehearsal.sampler, rehearsal.sample_id(kSalt + salt, place, places));
    const Cones cones = guide.at(at.point, at.normal);
    for (size_t i = 2 * place; i < 2 * place + 2; ++i) {
      const Vec2f which = numbers.pair(), u = numbers.pair();
      auto patch = static_cast<uint32_t>(which.x * static_cast<float>(patches.size()));
      if (i % 2 == 0) {
        if (cones.size() == 0) continue;
        patch = cones.name(cones.choose(which.x));
      }
      const Vec3f to = patches[patch].centre - at.point;
      const float distance = length(to), radius = patches[patch].radius;
      if (!(distance > radius)) continue;
      const float sine = radius / distance, rim = one_minus_cosine(sine * sine);
      const Vec3f direction = Frame(to / distance).to_world(direction_off_axis(rim * u.x, u.y));
      if (!(dot(direction, at.normal) > 0)) continue;
      Hit hit;
      const bool found = rehearsal.world.intersect({at.point, direction}, hit);
      const bool reached = found && length(hit.surface.position - patches[patch].centre) <= radius;
      glances[i] = {at.point, patch, reached};
    }
  });
  return taken(std::move(glances));
}

/// Somewhere on the way that light may take to a surface.
LitPoint in_the_air(const World& world, const Sighting& at, SampleCursor& numbers) {
  const Ray ray{at.point, Frame(at.normal).to_world(sample_cosine_hemisphere(numbers.pair()))};
  Hit hit;
  const float end = world.intersect(ray, hit) ? hit.distance : length(world.bounds().size());
  return {ray.at(end * numbers.single())};
}

/// Looks from places that paths came to at lights of a few branches, of each in turn.
std::vector<Glance> glance_at_lights(const Rehearsal& rehearsal, size_t most, uint64_t salt,
                                     const std::vector<Sighting>& sightings, Progress& progress) {
  const World& world = rehearsal.world;
  const size_t branches = world.lights().branches(), each = std::min(branches, kLightsAtOnce);
  const size_t step = std::max<size_t>(1, sightings.size() / std::max<size_t>(most, 1));
  const size_t places = sightings.size() / step;
  std::vector<Glance> glances(each * places, Glance{{0, 0, 0}, kNothing, false});
  parallel_together(places, [&](size_t place) {
    progress.check();
    const Sighting& at = sightings[place * step];
    SampleCursor numbers(rehearsal.sampler, rehearsal.sample_id(kSalt + salt, place, places));
    LitPoint point{at.point, at.normal};
    if (world.medium() && place % 2 == 1) point = in_the_air(world, at, numbers);
    for (size_t i = each * place; i < each * (place + 1); ++i) {
      const float which = numbers.single();
      const Vec2f u = numbers.pair();
      const LightChoice chosen = world.lights().choose_in(i % branches, point, which);
      if (chosen.light == kNoLight) continue;
      const LightSample s = world.lights().sample(chosen.light, point, u);
      if (!(s.pdf > 0) || (point.on_surface() && !(dot(s.direction, point.normal) > 0)) ||
          is_black(unshadowed(world, s, kNoObject)))
        continue;
      glances[i] = {point.position, static_cast<uint32_t>(i % branches),
                    !shadowed(world, {point.position, s.direction}, s.distance)};
    }
  });
  return taken(std::move(glances));
}

}  // namespace

Learned learn(const Rehearsal& rehearsal, uint64_t paths, const TrailedPath& gather,
              Progress& progress) {
  progress.begin("learning where light comes from", 2 * kRounds);
  const Box3f& bounds = rehearsal.world.bounds();
  const size_t branches = rehearsal.world.lights().branches();
  const auto places = static_cast<size_t>(kPlaces * static_cast<double>(paths));
  std::vector<Sighting> sightings;
  Learned learned;
  for (int round = 0; round < kRounds; ++round) {
    const auto salt = static_cast<uint64_t>(3 * round);
    watch(rehearsal, std::max<size_t>(1, (paths << round) >> kRounds), salt, learned, gather,
          progress, sightings);
    progress.advance();
    if (branches > 1)
      learned.lights = Chances(bounds, kRegion, branches,
                               glance_at_lights(rehearsal, places, salt + 1, sightings, progress));
    learned.guide = Guide(sightings, bounds);
    if (!learned.guide.empty())
      learned.guide.learn(
          glance_about(rehearsal, places, salt + 2, learned.guide, sightings, progress));
    progress.advance();
  }
  // Not before: paths that ended by it would tell less of what they end by.
  learned.surfaces = Brightness(sightings, bounds, kRegion);
  progress.end();
  return learned;
}

}  // namespace vug::render
