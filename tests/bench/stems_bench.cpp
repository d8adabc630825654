// One prototype for a grove: a moso culm with branches, twigs and leaves, from its L-system to a
// mesh of stems and a place for each leaf. The limit is 50 ms on one thread.
#include <benchmark/benchmark.h>
#include <vug/base/parallel.h>
#include <vug/flora/sweep_mesh.h>
#include <vug/session/load.h>
#include <vug/session/turtle_block.h>

#include <filesystem>

namespace {

using namespace vug;

const session::Loaded& moso() {
  static const session::Loaded loaded = [] {
    session::LoadOptions options;
    options.include_folders = {std::filesystem::path(VUG_DATA)};
    options.seed = 3;
    options.overrides = {{"LEAVES", "8"}};
    return session::load_text("include \"bamboo/moso_growth.vug\"\n", "bench.vug", options);
  }();
  return loaded;
}

flora::SweepOptions prototype() {
  flora::SweepOptions options;
  options.relief_orders = 1;
  return options;
}

void prototype_of_a_grove(benchmark::State& state) {
  const session::LSystemPlan& plan = *moso().shot.lsystems.at(0);
  const ThreadLimit threads(1);
  flora::MeshOptions mesh;
  mesh.tolerance = 1e-3;
  mesh.least_sides = 3;
  size_t leaves = 0, triangles = 0;
  for (auto _ : state) {
    const lsystem::Drawing drawing = session::drawing_of(plan).make();
    const mesh::Mesh stems = flora::swept_mesh(flora::tubes(drawing, prototype()), mesh);
    leaves = drawing.instances.size();
    triangles = stems.triangles.size();
    benchmark::DoNotOptimize(stems.positions.data());
  }
  state.counters["leaves"] = static_cast<double>(leaves);
  state.counters["triangles"] = static_cast<double>(triangles);
}
BENCHMARK(prototype_of_a_grove)->Unit(benchmark::kMillisecond);

void turtle(benchmark::State& state) {
  const session::LSystemPlan& plan = *moso().shot.lsystems.at(0);
  const ThreadLimit threads(1);
  for (auto _ : state) benchmark::DoNotOptimize(session::drawing_of(plan).make().instances.size());
}
BENCHMARK(turtle)->Unit(benchmark::kMillisecond);

}  // namespace
