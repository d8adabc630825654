// SPDX-License-Identifier: Apache-2.0
// Loading a scene of 10,000 slabs: written out, as calls of a function, and as a loop. The ratio to
// the written text is the cost of functions and loops.
#include <vug/loading/load.h>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <string>

namespace vug::loading {
namespace {

constexpr int kSlabs = 10000;
const std::string kFunction =
    "def slab(at, size = (2, 0.3, 1), turn = 0deg) =\n"
    "    box(size: size, rounding: r).rotate(angle: turn).translate(at) where r = 1cm\n";

std::string scene_of(const std::string& before, const std::string& solids) {
  return before + "let all = union(" + solids + ")\nvolume v = level_set(all, voxel: 10cm)\n";
}

/// A list with the text of each slab.
template <class Text>
std::string list_of(const Text& text) {
  std::string list = "[\n";
  for (int i = 0; i < kSlabs; ++i) list += text(i) + ",\n";
  return list + "]";
}

std::string written_out() {
  return scene_of(
      "", list_of([](int i) {
        return fmt::format(
            "box(size: (2, 0.3, 1), rounding: 1cm).rotate(angle: {}deg).translate(({}, 0, 0))",
            i % 360, i);
      }));
}

std::string calls() {
  return scene_of(kFunction, list_of([](int i) {
                    return fmt::format("slab(({}, 0, 0), turn: {}deg)", i, i % 360);
                  }));
}

std::string loop() {
  return scene_of(kFunction, fmt::format("[for i in 0..{}: slab((i, 0, 0), turn: mod(i, 360) * "
                                         "1deg)]",
                                         kSlabs - 1));
}

void load_scene(benchmark::State& state, const std::string& text) {
  for (auto _ : state) {
    const Loaded loaded = load_text(text, "bench.vug");
    if (!loaded.usable()) return state.SkipWithError(loaded.report().c_str());
    benchmark::DoNotOptimize(loaded.shot.volumes.size());
  }
}

BENCHMARK_CAPTURE(load_scene, written_out, written_out())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(load_scene, calls, calls())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(load_scene, loop, loop())->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vug::loading
