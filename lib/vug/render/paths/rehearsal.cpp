#include <vug/base/parallel.h>
#include <vug/render/camera.h>
#include <vug/render/paths/explore.h>
#include <vug/render/paths/rehearsal.h>
#include <vug/render/world.h>

#include <algorithm>

namespace vug::render {
namespace {

/// Rounds of looking, each with twice the paths of the one before and led by it.
constexpr int kRounds = 3;
/// Edge of the cubes in which brightness is averaged, in parts of the scene's diagonal.
constexpr float kCube = 1.0f / 128;

/// Calls with(ray, numbers) for camera rays all over the picture; `salt` tells rounds apart.
template <class With>
void for_camera_rays(const Rehearsal& rehearsal, uint64_t paths, uint64_t salt, Progress& progress,
                     const With& with) {
  constexpr uint64_t kChunk = 256;
  parallel_for((paths + kChunk - 1) / kChunk, [&](size_t chunk) {
    progress.check();
    SampleId id;
    id.spp = static_cast<uint32_t>(paths);
    id.seed = rehearsal.seed ^ (0x6775696465ull + salt);
    const uint64_t end = std::min(paths, (chunk + 1) * kChunk);
    for (uint64_t index = chunk * kChunk; index < end; ++index) {
      id.index = static_cast<uint32_t>(index);
      SampleCursor numbers(rehearsal.sampler, id);
      const Vec2f film = numbers.pair(), lens = numbers.pair();
      with(rehearsal.camera.ray(film, rehearsal.aspect, lens), numbers);
    }
  });
}

}  // namespace

Guide learn_guide(const Rehearsal& rehearsal, uint64_t paths, int max_bounces,
                  const TrailedPath& gather, Progress& progress) {
  const World& world = rehearsal.world;
  progress.begin("learning where light comes from", kRounds + 2);
  RadianceCache brightness(std::max(world.bounds().size().length(), 1e-3f) * kCube);
  for_camera_rays(rehearsal, paths, 0, progress, [&](const Ray& ray, SampleCursor& numbers) {
    Trail trail(brightness);
    gather(ray, numbers, trail);
  });
  progress.advance(2);
  Guide guide(world.bounds());
  for (int round = 0; round < kRounds; ++round) {
    GuideTraining training(guide);
    const Guide* leader = round > 0 ? &guide : nullptr;
    for_camera_rays(rehearsal, std::max<uint64_t>((paths << round) >> kRounds, 1),
                    1 + static_cast<uint64_t>(round), progress,
                    [&](const Ray& ray, SampleCursor& numbers) {
                      explore(world, ray, numbers, max_bounces, leader, brightness, training);
                    });
    guide = training.finish();
    progress.advance();
  }
  progress.end();
  return guide;
}

}  // namespace vug::render
