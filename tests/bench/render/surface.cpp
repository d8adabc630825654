// SPDX-License-Identifier: Apache-2.0
// Memory of a scene's rocks as meshes and as level sets (`object { direct true }`), and rays per
// second on one thread. One run for each, because the peak is that of the process.
//   bench_surface SCENE.vug mesh|direct [NAME=VALUE ...]
// Rays start at the camera and continue over four bounces, each with a shadow ray.
#include "../peak_memory.h"

#include <vug/base/error.h>
#include <vug/base/memory.h>
#include <vug/base/rng.h>
#include <vug/loading/load.h>
#include <vug/picture/picture.h>
#include <vug/render/prepared_scene.h>
#include <vug/render/sampling.h>

#include <fmt/format.h>

#include <cstdio>
#include <ctime>

namespace {

using namespace vug;
Vec2f pair(RandomStream& random) {
  const auto x = static_cast<float>(random.uniform());
  return {x, static_cast<float>(random.uniform())};
}

/// Rays per second of processor time, which other processes disturb less.
double speed(const render::PreparedScene& world, const render::Camera& camera, int paths) {
  RandomStream random(RandomKey(1));
  size_t rays = 0;
  const std::clock_t start = std::clock();
  for (int i = 0; i < paths; ++i) {
    const Vec2f place = pair(random), lens = pair(random);
    render::Ray ray = camera.ray(place, 16 / 9.0f, lens);
    for (int bounce = 0; bounce < 5; ++bounce) {
      render::Hit hit;
      ++rays;
      if (!world.intersect(ray, hit)) break;
      const render::Frame frame(hit.surface.shading_normal);
      const auto next = [&] {
        return render::Ray{hit.origin,
                           frame.to_world(render::sample_cosine_hemisphere(pair(random)))};
      };
      ++rays;
      world.occluded(next(), render::kFar);
      ray = next();
    }
  }
  return static_cast<double>(rays) * CLOCKS_PER_SEC / static_cast<double>(std::clock() - start);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print("bench_surface SCENE.vug mesh|direct [NAME=VALUE ...]\n");
    return 0;
  }
  try {
    loading::LoadOptions options;
    for (int i = 3; i < argc; ++i) {
      const std::string text = argv[i];
      options.overrides.push_back(
          {text.substr(0, text.find('=')), text.substr(text.find('=') + 1)});
    }
    loading::Loaded loaded = loading::load(argv[1], options);
    for (shot::ObjectPlan& object : loaded.shot.objects)
      object.direct = std::string(argv[2]) == "direct" && object.emission.length2() == 0;
    building::Builder builder(loaded.shot);
    const auto held = [] { return static_cast<double>(resident_memory()); };
    double active = 0;
    for (const shot::ObjectPlan& object : loaded.shot.objects)
      active +=
          static_cast<double>(builder.level_set(object.mesh->volume).statistics().active_voxels);
    const double grids = held();
    const render::Scene scene = picture::build_scene(builder, picture::plan_picture(loaded.shot));
    const double made = held();
    const render::PreparedScene world(scene);
    const double tree = held(), peak = peak_memory();
    size_t triangles = 0, bricks = 0;
    for (const render::Object& object : scene.objects) {
      if (object.mesh) triangles += object.mesh->triangles.size();
      if (object.surface) bricks += object.surface->bricks().size();
    }
    fmt::print("{:.3g} active voxels, {} triangles, {} bricks\n", active, triangles, bricks);
    fmt::print("with grids {}; meshes or surfaces {:.1f} and trees {:.1f} bytes a voxel; peak {}\n",
               bytes_text(grids), (made - grids) / active, (tree - made) / active,
               bytes_text(peak));
    double best = 0;
    speed(world, *scene.camera, 20000);
    for (int round = 0; round < 3; ++round)
      best = std::max(best, speed(world, *scene.camera, 50000));
    fmt::print("{:.3f} M rays/s, built in {:.1f} s\n", 1e-6 * best, builder.seconds());
  } catch (const Error& error) {
    fmt::print(stderr, "bench_surface: {}\n", error.what());
    return 2;
  }
  return 0;
}
