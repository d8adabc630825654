// SPDX-License-Identifier: Apache-2.0
// A large scene: 40 million triangles in world space and 2,000 instances of stones. Prints the
// estimated memory and time, and the actual ones.
//   bench_crowd [millions of triangles] [instances] [samples per pixel]
#include "../peak_memory.h"

#include <vug/base/memory.h>
#include <vug/base/rng.h>
#include <vug/mesh/shapes.h>
#include <vug/render/kinds.h>
#include <vug/render/render.h>

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

using namespace vug;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A square of hills with 2 n^2 triangles, 40 m wide.
mesh::MeshPtr hills(size_t n, float height) {
  mesh::Mesh mesh;
  mesh.positions.reserve((n + 1) * (n + 1));
  mesh.normals.reserve((n + 1) * (n + 1));
  mesh.triangles.reserve(2 * n * n);
  for (size_t i = 0; i <= n; ++i)
    for (size_t j = 0; j <= n; ++j) {
      const auto x = 40 * static_cast<float>(i) / static_cast<float>(n) - 20;
      const auto z = 40 * static_cast<float>(j) / static_cast<float>(n) - 20;
      const float y = height + 0.5f * std::sin(x) * std::sin(z) + 0.01f * std::sin(37 * x + 11 * z);
      mesh.positions.push_back({x, y, z});
      mesh.normals.push_back({0, 1, 0});
    }
  for (size_t i = 0; i < n; ++i)
    for (size_t j = 0; j < n; ++j) {
      const auto at = static_cast<uint32_t>(i * (n + 1) + j),
                 next = at + static_cast<uint32_t>(n) + 1;
      mesh.triangles.push_back({at, at + 1, next + 1});
      mesh.triangles.push_back({at, next + 1, next});
    }
  return std::make_shared<const mesh::Mesh>(std::move(mesh));
}

render::Object object(const mesh::MeshPtr& mesh, const char* name) {
  render::Object out;
  out.name = name;
  out.mesh = mesh;
  out.material = render::make_material("lambert", {{"albedo", Vec3d(0.5)}});
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  const double millions = argc > 1 ? std::atof(argv[1]) : 40;
  const int instances = argc > 2 ? std::atoi(argv[2]) : 2000;
  render::Options options;
  options.width = 640, options.height = 360;
  options.spp = argc > 3 ? std::atoi(argv[3]) : 16;

  render::Scene scene;
  const auto n = static_cast<size_t>(std::sqrt(millions * 1e6 / 4));
  scene.objects.push_back(object(hills(n, 0), "floor"));
  scene.objects.push_back(object(hills(n, 6), "roof"));
  std::vector<mesh::MeshPtr> stones;
  for (int i = 0; i < 4; ++i)
    stones.push_back(
        std::make_shared<const mesh::Mesh>(mesh::sphere_mesh(Vec3d(0), 0.2 + 0.05 * i, 5)));
  RandomStream random(RandomKey(1));
  for (int i = 0; i < instances; ++i) {
    render::Object stone = object(stones[static_cast<size_t>(i % 4)], "stones");
    const double x = random.uniform(-15, 15), z = random.uniform(-15, 15),
                 size = random.uniform(0.5, 2);
    stone.instance = std::make_shared<const render::InstanceTransform>(
        Transform::translation({x, 0.5 * std::sin(x) * std::sin(z), z}) *
        Transform::rotation({0, 1, 0}, random.uniform(0, 6)) *
        Transform::scaling({size, 0.6 * size, size}));
    scene.objects.push_back(std::move(stone));
  }
  scene.lights.push_back(render::make_light(
      "sphere", {{"center", Vec3d(0, 4, 0)}, {"radius", 0.3}, {"radiance", Vec3d(60)}}));
  scene.lights.push_back(render::make_light("sky", {{"radiance", Vec3d(1)}}));
  scene.camera = render::make_camera("perspective",
                                     {{"eye", Vec3d(-14, 2.5, 3)}, {"target", Vec3d(0, 1.5, 0)}});

  const double held = static_cast<double>(resident_memory());
  const double promised = held + render::memory_estimate(scene, options);
  fmt::print("{} triangles in world space, {} instances: {} held, {} estimated\n", 4 * n * n,
             instances, bytes_text(held), bytes_text(promised));
  std::fflush(stdout);
  double told = 0;
  const Clock::time_point start = Clock::now();
  Clock::time_point ready = start;
  render::RenderCallbacks callbacks;
  callbacks.estimate = [&](double seconds) { told = seconds, ready = Clock::now(); };
  render::render(scene, options, Progress::none(), callbacks);
  const double peak = peak_memory(), all = seconds_since(start), rendering = seconds_since(ready);
  fmt::print("{} at the peak: {:.2f} of the estimate\n", bytes_text(peak), peak / promised);
  fmt::print("{:.1f} s of building; {:.1f} s of rendering, {:.2f} of the estimated {:.1f} s\n",
             all - rendering, rendering, rendering / told, told);
  return peak < 16.0 * (1u << 30) ? 0 : 1;
}
