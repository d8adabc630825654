// SPDX-License-Identifier: Apache-2.0
// One prototype for a grove: a moso culm with branches, twigs and leaves, from its L-system to a
// mesh of stems and an instance for each leaf. The limit is 50 ms on one thread.
#include <benchmark/benchmark.h>
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/flora/sweep_field.h>
#include <vug/flora/sweep_mesh.h>
#include <vug/loading/load.h>
#include <vug/shot/lsystem_plan.h>

#include <filesystem>

namespace {

using namespace vug;

const loading::Loaded& moso() {
  static const loading::Loaded loaded = [] {
    loading::LoadOptions options;
    options.include_folders = {std::filesystem::path(VUG_DATA)};
    options.seed = 3;
    options.overrides = {{"LEAVES", "8"}};
    return loading::load_text("include \"bamboo/moso_growth.vug\"\n", "bench.vug", options);
  }();
  return loaded;
}

flora::SweepOptions prototype() {
  flora::SweepOptions options;
  options.displaced_orders = 1;
  return options;
}

void prototype_of_a_grove(benchmark::State& state) {
  const shot::LSystemPlan& plan = *moso().shot.lsystems.at(0);
  with_threads(1, [&] {
    flora::MeshOptions mesh;
    mesh.tolerance = 1e-3;
    mesh.min_sides = 3;
    size_t leaves = 0, triangles = 0;
    for (auto _ : state) {
      const lsystem::Drawing drawing = plan.draw();
      const mesh::Mesh stems = flora::swept_mesh(flora::tubes(drawing, prototype()), mesh);
      leaves = drawing.instances.size();
      triangles = stems.triangles.size();
      benchmark::DoNotOptimize(stems.positions.data());
    }
    state.counters["leaves"] = static_cast<double>(leaves);
    state.counters["triangles"] = static_cast<double>(triangles);
  });
}
BENCHMARK(prototype_of_a_grove)->Unit(benchmark::kMillisecond);

void turtle(benchmark::State& state) {
  const shot::LSystemPlan& plan = *moso().shot.lsystems.at(0);
  with_threads(1, [&] {
    for (auto _ : state) benchmark::DoNotOptimize(plan.draw().instances.size());
  });
}
BENCHMARK(turtle)->Unit(benchmark::kMillisecond);

/// A culm without branches, as a solid to be united with rock, and points near its bark.
struct Solid {
  field::Field field;
  std::vector<Vec3d> near;
};
const Solid& solid() {
  static const Solid made = [] {
    lsystem::Drawing culm = *moso().shot.lsystems.at(0)->drawing();
    culm.axes.resize(1);
    flora::SweepOptions options;
    options.wall = 0.2;
    const std::vector<flora::Tube> tubes = flora::tubes(culm, options);
    Solid out{flora::swept(tubes), {}};
    RandomStream random(RandomKey(1).at("near"));
    for (int i = 0; i < 4000; ++i) {
      const double along = random.uniform(tubes[0].start(), tubes[0].end());
      out.near.push_back(tubes[0].point(along, random.uniform(-3, 3),
                                        tubes[0].radius(along) * random.uniform(0.9, 1.2)));
    }
    return out;
  }();
  return made;
}

void value_of_a_culm(benchmark::State& state) {
  double sum = 0;
  for (auto _ : state)
    for (const Vec3d& p : solid().near) sum += solid().field.value(p);
  benchmark::DoNotOptimize(sum);
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(solid().near.size()));
}
BENCHMARK(value_of_a_culm)->Unit(benchmark::kMillisecond);

void value_and_gradient_of_a_culm(benchmark::State& state) {
  double sum = 0;
  for (auto _ : state)
    for (const Vec3d& p : solid().near) sum += solid().field.gradient(p).gradient.x;
  benchmark::DoNotOptimize(sum);
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(solid().near.size()));
}
BENCHMARK(value_and_gradient_of_a_culm)->Unit(benchmark::kMillisecond);

}  // namespace
