#include <vug/base/parallel.h>
#include <vug/render/camera.h>
#include <vug/render/paths/rehearsal.h>
#include <vug/render/sampling.h>
#include <vug/render/world.h>

#include <algorithm>

namespace vug::render {
namespace {

/// Rounds of gathering, each with twice the paths of the one before and led by it: what few paths
/// come to by chance, many come to in the next.
constexpr int kRounds = 3;
constexpr size_t kChunk = 256;
/// Glances are taken from so many places for each path of a round, evenly over all sightings.
constexpr double kPlaces = 0.5;

SampleId sample_id(const Rehearsal& rehearsal, uint64_t salt, size_t index, size_t count) {
  SampleId id;
  id.seed = rehearsal.seed ^ (0x6775696465ull + salt);
  id.spp = static_cast<uint32_t>(count);
  id.index = static_cast<uint32_t>(index);
  return id;
}

/// What `paths` camera rays all over the picture see, in their order.
void watch(const Rehearsal& rehearsal, size_t paths, uint64_t salt, const Guide& guide,
           const TrailedPath& gather, Progress& progress, std::vector<Sighting>& sightings) {
  std::vector<std::vector<Sighting>> chunks((paths + kChunk - 1) / kChunk);
  parallel_for(chunks.size(), [&](size_t chunk) {
    progress.check();
    const size_t end = std::min(paths, (chunk + 1) * kChunk);
    for (size_t index = chunk * kChunk; index < end; ++index) {
      SampleCursor numbers(rehearsal.sampler, sample_id(rehearsal, salt, index, paths));
      const Vec2f film = numbers.pair(), lens = numbers.pair();
      Trail trail(chunks[chunk]);
      gather(rehearsal.camera.ray(film, rehearsal.aspect, lens), numbers, guide, trail);
    }
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
  std::vector<Glance> glances(2 * places);
  std::vector<char> taken(2 * places, 0);
  parallel_for(
      places,
      [&](size_t place) {
        progress.check();
        const Sighting& at = sightings[place * step];
        SampleCursor numbers(rehearsal.sampler, sample_id(rehearsal, salt, place, places));
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
          Cones only;
          only.add(to / distance, Cones::opening(radius / distance), 1, patch);
          only.settle(1);
          const Vec3f direction = only.sample(u);
          if (!(dot(direction, at.normal) > 0)) continue;
          Hit hit;
          const bool found = rehearsal.world.intersect({at.point, direction}, hit);
          const bool reached =
              found && length(hit.surface.position - patches[patch].centre) <= radius;
          glances[i] = {at.point, patch, reached};
          taken[i] = 1;
        }
      },
      64);
  size_t kept = 0;
  for (size_t i = 0; i < glances.size(); ++i)
    if (taken[i]) glances[kept++] = glances[i];
  glances.resize(kept);
  return glances;
}

}  // namespace

Guide learn_guide(const Rehearsal& rehearsal, uint64_t paths, const TrailedPath& gather,
                  Progress& progress) {
  progress.begin("learning where light comes from", 2 * kRounds);
  std::vector<Sighting> sightings;
  Guide guide;
  for (int round = 0; round < kRounds; ++round) {
    const auto salt = static_cast<uint64_t>(2 * round);
    watch(rehearsal, std::max<size_t>(1, (paths << round) >> kRounds), salt, guide, gather,
          progress, sightings);
    progress.advance();
    guide = Guide(sightings, rehearsal.world.bounds());
    if (!guide.empty())
      guide = Guide(guide, glance_about(rehearsal, static_cast<size_t>(kPlaces * double(paths)),
                                        salt + 1, guide, sightings, progress));
    progress.advance();
  }
  progress.end();
  return guide;
}

}  // namespace vug::render
