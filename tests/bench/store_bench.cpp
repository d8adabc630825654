// SPDX-License-Identifier: Apache-2.0
// A build without a store, one that fills an empty store, and one that finds everything in it.
#include <vug/base/scratch_folder.h>
#include <vug/building/builder.h>
#include <vug/loading/load.h>

#include <benchmark/benchmark.h>

namespace {

using namespace vug;

/// About 3 million active voxels.
const char* const kScene =
    "let rough = displace(union([sphere(2m), box(size: (3, 1, 2))], blend: smooth(20cm)),\n"
    "  noise: fbm(scale: 40cm, octaves: 8), amount: 10cm)\n"
    "volume rock = level_set(rough, voxel: 1cm)\n"
    "mesh skin on rock {}\n";

void build(benchmark::State& state, const building::StoreUse& use) {
  const loading::Loaded loaded = loading::load_text(kScene, "store_bench.vug");
  building::BuildOptions how;
  how.stored = use;
  building::Builder builder(loaded.shot, how);
  const auto vertices = builder.mesh(loaded.shot.meshes.at(0))->positions.size();
  state.counters["vertices"] = static_cast<double>(vertices);
}

building::StoreUse store_in(const ScratchFolder& folder) {
  building::StoreUse use;
  use.store = std::make_shared<store::Store>(store::StoreOptions{folder.path()});
  return use;
}

void without_store(benchmark::State& state) {
  for (auto each : state) build(state, {});
}
void empty_store(benchmark::State& state) {
  for (auto each : state) {
    const ScratchFolder folder("vug_store_bench");
    build(state, store_in(folder));
  }
}
void filled_store(benchmark::State& state) {
  const ScratchFolder folder("vug_store_bench");
  build(state, store_in(folder));
  for (auto each : state) build(state, store_in(folder));
}

BENCHMARK(without_store)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(empty_store)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(filled_store)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
