// SPDX-License-Identifier: Apache-2.0
// Answers to an editor about a text of 2,000 lines, each after a change of the text.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <vug/language/colours.h>
#include <vug/language/completion.h>
#include <vug/language/hover.h>
#include <vug/language/inlay_hints.h>
#include <vug/language/navigation.h>
#include <vug/language/outline.h>
#include <vug/language/rename.h>
#include <vug/language/semantic_tokens.h>
#include <vug/language/signature.h>

#include <functional>

namespace vug::language {
namespace {

constexpr const char* kFile = "/scenes/long.vug";
constexpr int kBlocks = 250;

/// Eight lines for each block, which use names of the block before.
std::string long_text() {
  std::string text = "param voxel = 4cm\nlet r0 = 1m\n";
  for (int i = 1; i <= kBlocks; ++i)
    text += fmt::format(
        "# Block {0}: a ball with a hole.\nlet r{0} = 0.5 * r{1} + 10 * voxel\n"
        "def ball{0}(size, hole = 0.2 * size) = difference(sphere(size), [sphere(hole)])\n"
        "volume rock{0} = level_set(ball{0}(r{0}).translate((0, 1, 0)), voxel: voxel)\n"
        "mesh skin{0} on rock{0} {{ paint (0.5, 0.2, 0.1) }}\n"
        "object body{0} on skin{0} {{\n  material lambert(albedo: (0.5, 0.4, 0.3))\n}}\n",
        i, i - 1);
  return text;
}

using Request = std::function<void(const Workspace&, const Analysis&)>;

void run(benchmark::State& state, const Request& request) {
  const std::string text = long_text();
  Workspace workspace;
  for (auto _ : state) {
    workspace.open(kFile, text);  // the analysis is part of each answer
    request(workspace, *workspace.analyse(kFile));
  }
}

const Position kPlace{8 * kBlocks / 2 + 6, 33};  // inside the call of a ball

void complete_call(benchmark::State& state) {
  run(state, [](const Workspace& w, const Analysis& a) { complete(w, a, kPlace); });
}
void describe_word(benchmark::State& state) {
  run(state, [](const Workspace&, const Analysis& a) { hover_at(a, kPlace); });
}
void help_with_call(benchmark::State& state) {
  run(state, [](const Workspace&, const Analysis& a) { signatures_at(a, kPlace); });
}
void find_definition(benchmark::State& state) {
  run(state, [](const Workspace&, const Analysis& a) { definition_at(a, kPlace); });
}
void rename_param(benchmark::State& state) {
  run(state, [](const Workspace& w, const Analysis& a) { rename(w, a, {1, 8}, "edge"); });
}
void list_outline(benchmark::State& state) {
  run(state, [](const Workspace&, const Analysis& a) { outline_of(a); });
}
void colour_tokens(benchmark::State& state) {
  run(state, [](const Workspace&, const Analysis& a) { semantic_tokens(a); });
}
void find_swatches(benchmark::State& state) {
  run(state, [](const Workspace&, const Analysis& a) { swatches_of(a); });
}
void show_values(benchmark::State& state) {
  run(state, [](const Workspace&, const Analysis& a) { inlay_hints(a, 1, 2000); });
}

BENCHMARK(complete_call)->Unit(benchmark::kMillisecond);
BENCHMARK(describe_word)->Unit(benchmark::kMillisecond);
BENCHMARK(help_with_call)->Unit(benchmark::kMillisecond);
BENCHMARK(find_definition)->Unit(benchmark::kMillisecond);
BENCHMARK(rename_param)->Unit(benchmark::kMillisecond);
BENCHMARK(list_outline)->Unit(benchmark::kMillisecond);
BENCHMARK(colour_tokens)->Unit(benchmark::kMillisecond);
BENCHMARK(find_swatches)->Unit(benchmark::kMillisecond);
BENCHMARK(show_values)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vug::language
