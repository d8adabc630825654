// SPDX-License-Identifier: Apache-2.0
// Cost of many lights: samples per second of the same room with 10, 100, ... 10,000 lights of the
// same total power, and the cost of one choice by the tree and of a uniform choice. The benefit of
// the tree is measured as the mean squared error of the light at points of the room for equal time.
#include <vug/base/rng.h>
#include <vug/mesh/shapes.h>
#include <vug/render/kinds.h>
#include <vug/render/lighting/light_set.h>
#include <vug/render/render.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace {
using namespace vug;          // NOLINT
using namespace vug::render;  // NOLINT

double seconds() {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

std::vector<LightPtr> many_lights(int count) {
  RandomStream random{RandomKey(1)};
  std::vector<LightPtr> out;
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(-9, 9), y = random.uniform(-2, 2);
    out.push_back(make_light("sphere", {{"center", Vec3d(x, y, random.uniform(-4, 4))},
                                        {"radius", 0.01},
                                        {"power", 100.0 / count},
                                        {"visible", false}}));
  }
  return out;
}

Scene room(int count) {
  Scene scene;
  render::Object walls;
  walls.name = "walls";
  walls.mesh = std::make_shared<mesh::Mesh>(mesh::box_mesh({Vec3d(-10, -3, -5), Vec3d(10, 3, 5)}));
  scene.objects = {walls};
  scene.camera =
      make_camera("perspective", {{"eye", Vec3d(-9, 0, 4)}, {"target", Vec3d(5, 0, -2)}});
  scene.lights = many_lights(count);
  return scene;
}

double samples_per_second(int count) {
  const Scene scene = room(count);
  Options options;
  options.width = 160, options.height = 90, options.spp = 16, options.max_bounces = 3;
  double begin = 0;
  Progress progress([&](const std::string& stage, double fraction) {
    if (stage == "rendering" && fraction == 0) begin = seconds();
  });
  render::render(scene, options, progress);
  return options.width * options.height * options.spp / (seconds() - begin);
}

struct Choice {
  double nanoseconds = 0, variance = 0;
};

/// One choice and its estimate of the light at points of the room, by the tree or uniformly.
Choice choose(const LightSet& set, LightId count, bool tree) {
  constexpr int kPoints = 50, kDraws = 2000;
  RandomStream random{RandomKey(2)};
  const auto one = [&] { return static_cast<float>(random.bits() >> 8) * 0x1p-24f; };
  Choice out;
  for (int p = 0; p < kPoints; ++p) {
    const LightSampleContext point{{static_cast<float>(random.uniform(-9, 9)), -3, 0}, {0, 1, 0}};
    double sum = 0, squares = 0;
    const double start = seconds();
    for (int i = 0; i < kDraws; ++i) {
      LightChoice c{random.below(count), 1 / static_cast<float>(count)};
      if (tree) {
        LightSelection selection;
        const LightChoices chosen = set.choose(point, one(), selection);
        if (chosen.size() == 0) continue;
        c = *chosen.begin();
      }
      const LightSample s = set.sample(c.light, point, {0.5f, 0.5f});
      const auto value =
          static_cast<double>(luminance(s.radiance) * s.direction.y / (s.pdf * c.probability));
      sum += value, squares += value * value;
    }
    out.nanoseconds += (seconds() - start) * 1e9 / kDraws / kPoints;
    const double mean = sum / kDraws;
    out.variance += (squares / kDraws / (mean * mean) - 1) / kPoints;
  }
  return out;
}

}  // namespace

int main() {
  samples_per_second(10);  // warm-up
  double ten = 0;
  fmt::print(
      "lamps | M samples/s | of that with 10 | choice ns | even ns | variance | even | worth\n");
  for (const int count : {10, 100, 1000, 10000}) {
    double best = 0;
    for (int run = 0; run < 3; ++run) best = std::max(best, samples_per_second(count));
    if (count == 10) ten = best;
    const LightSet set(many_lights(count), {});
    const Choice tree = choose(set, static_cast<LightId>(count), true);
    const Choice even = choose(set, static_cast<LightId>(count), false);
    fmt::print("{} | {:.3f} | {:.2f} | {:.0f} | {:.0f} | {:.3g} | {:.3g} | {:.1f}\n", count,
               best * 1e-6, best / ten, tree.nanoseconds, even.nanoseconds, tree.variance,
               even.variance,
               even.variance * even.nanoseconds / (tree.variance * tree.nanoseconds));
  }
  return 0;
}
