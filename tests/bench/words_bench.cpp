// SPDX-License-Identifier: Apache-2.0
// Rewriting parametric words: modules per second with one thread and with two, in alternation, and
// the speed-up of two; compared with handwritten loops for a single rule and with copying the
// bytes.
#include <vug/base/parallel.h>
#include <vug/lsystem/compile.h>
#include <vug/lsystem/derive.h>
#include <vug/scene/parser.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>

namespace vug::lsystem {
namespace {

// Steps that end in words of five and of three million modules; all steps together produce twice as
// many.
constexpr int kSteps = 20, kChanceSteps = 24;

/// One rule with a guard, computed parameters and a branch, and one that only computes.
const char* const kPlant = R"(grammar plant: lsystem {
  axiom A(1, 0.1)
  A(l, w) if l > 0.0001 -> F(l, w)[+(0.5rad)A(l*0.7, w*0.6)]A(l*0.9, w)
  F(l, w) -> F(l*1.01, w + 0.001)
})";
/// The same with a choice between two rules and up to three draws in each.
const char* const kChancePlant = R"(grammar plant: lsystem {
  axiom A(1, 0.1)
  A(l, w) @3 -> F(l, w)[+(0.3rad..0.7rad)A(l*(0.6..0.8), w*0.6)]A(l*(0.8..1), w)
  A(l, w) @1 -> F(l, w)/(0rad..3rad)A(l*0.9, w)
  F(l, w) -> F(l*1.01, w + 0.001)
})";
const char* const kSteady = R"(grammar steady: lsystem {
  axiom A(1, 2)
  A(x, y) if x < 1000000000 -> A(x*0.5 + y, y)
})";
const char* const kChance = R"(grammar chance: lsystem {
  axiom A(1, 2)
  A(x, y) @1 -> A(x*0.5, y)
  A(x, y) @2 -> A(x*0.5, 0.5..y)
})";

SystemPtr system_of(const char* text) {
  Diagnostics diagnostics;
  const scene::Document document = scene::parse(text, "bench", diagnostics);
  scene::Resolver resolver;
  scene::Evaluator evaluator(document, resolver, diagnostics);
  return compile(document.grammars.at(0), evaluator,
                 [](const auto&, const auto&) { return nullptr; });
}

/// Runs `work`, which returns the number of modules produced, with one thread and with two in turn.
/// The fastest runs of each count: other work on the machine slows the rest down.
template <class Work>
void by_one_and_two(benchmark::State& state, const Work& work) {
  std::array<double, 2> fastest{1e9, 1e9};
  int64_t made = 0;
  for (auto _ : state) {
    double both = 0;
    for (const size_t which : {0, 1}) {
      with_threads(which == 0 ? 1 : 2, [&] {
        const auto start = std::chrono::steady_clock::now();
        made = work();
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        fastest[which] = std::min(fastest[which], taken.count());
        both += taken.count();
      });
    }
    state.SetIterationTime(both);
  }
  state.counters["one"] = static_cast<double>(made) / fastest[0];
  state.counters["two"] = static_cast<double>(made) / fastest[1];
  state.counters["times"] = fastest[0] / fastest[1];
}

void Plant(benchmark::State& state, const char* text, int steps) {
  const SystemPtr system = system_of(text);
  by_one_and_two(state, [&] {
    int64_t made = 0;
    Rewriter rewriter(*system);
    Derivation word;
    rewriter.start(word);
    for (int step = 0; step < steps; ++step) {
      rewriter.rewrite(system->books[0], word, RewriteMode::step);
      made += static_cast<int64_t>(word.word.size());
    }
    benchmark::DoNotOptimize(word.word.symbols().data());
    return made;
  });
}
BENCHMARK_CAPTURE(Plant, certain, kPlant, kSteps)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Plant, chance, kChancePlant, kChanceSteps)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

/// The same two rules as handwritten code: the engine's arrays, no bytecode, one pass.
struct Rows {
  UninitializedVector<SymbolId> symbols;
  UninitializedVector<uint32_t> ends;
  UninitializedVector<double> values;
};

void grow(const Rows& in, Rows& out) {
  enum : SymbolId { kA, kF, kOpen, kTurn, kClose };
  const auto put = [&](SymbolId symbol) {
    out.symbols.push_back(symbol);
    out.ends.push_back(static_cast<uint32_t>(out.values.size()));
  };
  const auto pair = [&](double a, double b) {
    out.values.push_back(a);
    out.values.push_back(b);
  };
  out.symbols.clear(), out.ends.clear(), out.values.clear();
  for (size_t i = 0; i < in.symbols.size(); ++i) {
    const double* v = in.values.data() + (i == 0 ? 0 : in.ends[i - 1]);
    if (in.symbols[i] == kA && v[0] > 0.0001) {
      pair(v[0], v[1]), put(kF);
      put(kOpen);
      out.values.push_back(0.5), put(kTurn);
      pair(v[0] * 0.7, v[1] * 0.6), put(kA);
      put(kClose);
      pair(v[0] * 0.9, v[1]), put(kA);
    } else if (in.symbols[i] == kF) {
      pair(v[0] * 1.01, v[1] + 0.001), put(kF);
    } else {
      for (size_t k = i == 0 ? 0 : in.ends[i - 1]; k < in.ends[i]; ++k)
        out.values.push_back(in.values[k]);
      put(in.symbols[i]);
    }
  }
}

void PlantByHand(benchmark::State& state) {
  int64_t made = 0;
  for (auto _ : state) {
    Rows word{{0}, {2}, {1, 0.1}}, next;
    for (int step = 0; step < kSteps; ++step) {
      grow(word, next);
      std::swap(word, next);
      made += static_cast<int64_t>(word.symbols.size());
    }
    benchmark::DoNotOptimize(word.symbols.data());
  }
  state.SetItemsProcessed(made);
}
BENCHMARK(PlantByHand)->UseRealTime()->Unit(benchmark::kMillisecond);

Word row_of(const System& system, size_t count) {
  Word word;
  const double values[] = {1, 2};
  for (size_t i = 0; i < count; ++i) word.append(system.axiom.symbols[0], values);
  return word;
}

constexpr size_t kRow = 1 << 20;

/// A row of modules, each replaced by one module in every step.
void Steady(benchmark::State& state, const char* text) {
  const SystemPtr system = system_of(text);
  Rewriter rewriter(*system);
  Derivation word{row_of(*system, kRow), {}};
  if (system->random)
    for (size_t i = 0; i < kRow; ++i) word.keys.push_back(i);
  by_one_and_two(state, [&] {
    rewriter.rewrite(system->books[0], word, RewriteMode::step);
    return static_cast<int64_t>(kRow);
  });
}
BENCHMARK_CAPTURE(Steady, guarded, kSteady)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Steady, chance, kChance)->UseManualTime()->Unit(benchmark::kMillisecond);

/// The time of copying such a row: the limit set by the memory bandwidth.
void CopyRow(benchmark::State& state) {
  const SystemPtr system = system_of(kSteady);
  const Word from = row_of(*system, kRow);
  Word to = from;
  for (auto _ : state) {
    std::memcpy(to.symbols().data(), from.symbols().data(), from.symbols().size_bytes());
    std::memcpy(to.starts().data(), from.starts().data(), from.starts().size_bytes());
    std::memcpy(to.values().data(), from.values().data(), from.values().size_bytes());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * kRow));
}
BENCHMARK(CopyRow)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vug::lsystem
