// SPDX-License-Identifier: Apache-2.0
// Additional camera rays at bright edges reduce the noise and leave everything else unchanged.
#include "scenes.h"

#include <gtest/gtest.h>
#include <vug/render/render.h>

#include <cmath>

namespace vug::render {
namespace {

/// An emissive ball over a grey floor, before a bright sky.
Scene glow() {
  Scene scene;
  scene.objects.push_back(object(mesh::sphere_mesh(Vec3d(0, 1, 0), 0.5, 4), 0.5));
  scene.objects.back().emission = {8, 6, 4};
  scene.objects.push_back(object(floor_mesh(2), 0.3));
  scene.lights.push_back(make_light("sky", {{"radiance", Vec3d(2)}}));
  scene.camera = view({0, 1.5, 4}, {0, 0.8, 0}, 0.8);
  return scene;
}

/// Mean of a picture's light over `kRuns` seeds, its standard error, and the mean over all pixels
/// of their variance between seeds.
struct Noise {
  double mean = 0, error = 0, pixels = 0;
};

Noise noise(const Scene& scene, bool edges, const std::string& name) {
  constexpr int kRuns = 6, kSide = 32;
  std::vector<double> sum(kSide * kSide), square(kSide * kSide);
  double mean = 0, means = 0;
  for (int run = 0; run < kRuns; ++run) {
    Options o = options(kSide, kSide, 64, 0);
    o.aovs = scene_aovs(scene, {"beauty", "emission"});
    o.bright_edges = edges;
    o.seed = static_cast<uint64_t>(run);
    const image::Image picture = render(scene, o);
    const auto channel = static_cast<size_t>(picture.find_channel(name));
    double all = 0;
    for (size_t i = 0; i < sum.size(); ++i) {
      const auto value = static_cast<double>(picture.pixels[i * picture.channels.size() + channel]);
      all += value / static_cast<double>(sum.size());
      sum[i] += value / kRuns;
      square[i] += value * value / kRuns;
    }
    mean += all / kRuns, means += all * all / kRuns;
  }
  Noise out{mean, std::sqrt((means - mean * mean) / (kRuns - 1)), 0};
  for (size_t i = 0; i < sum.size(); ++i)
    out.pixels += (square[i] - sum[i] * sum[i]) / static_cast<double>(sum.size());
  return out;
}

TEST(BrightEdges, KeepTheMeanAndReduceTheNoise) {
  const Scene scene = glow();
  // Light from the first surface has the same noise as before.
  const std::pair<const char*, double> cases[] = {{"G", 0.5}, {"emission.G", 0.08}};
  for (const auto& [name, left] : cases) {
    SCOPED_TRACE(name);
    const Noise plain = noise(scene, false, name), more = noise(scene, true, name);
    EXPECT_LT(std::fabs(more.mean - plain.mean), 4 * std::hypot(more.error, plain.error));
    EXPECT_LT(more.pixels, left * plain.pixels);
    EXPECT_GT(plain.mean, 0.5);
  }
}

}  // namespace
}  // namespace vug::render
