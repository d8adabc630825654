// SPDX-License-Identifier: Apache-2.0
#include "scene_options.h"
#include "sha256.h"

#include <vug/base/parallel.h>
#include <vug/shot/lsystem_plan.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <map>

namespace vug::cli {
namespace {

using Json = nlohmann::ordered_json;

struct DeriveOptions {
  SceneOptions scene;
  std::string grammar;
  std::optional<int> steps;
  std::optional<double> time;
  int threads = 0;
  bool drawn = false;
  bool count = false;
  bool hash = false;
  bool json = false;
};

/// The L-system of that name. An empty name selects the only one; error if there are several.
shot::LSystemPtr select_lsystem(const shot::Shot& shot, const std::string& wanted) {
  std::vector<std::string> names;
  for (const shot::LSystemPtr& each : shot.lsystems) {
    if (each->name == wanted) return each;
    names.push_back(each->name);
  }
  if (names.empty())
    throw Error(
        ErrorCode::bad_input, "the scene has no L-system", {},
        "declare one with 'grammar NAME: lsystem { ... }'; 'vug tree' shows other grammars");
  if (!wanted.empty())
    throw Error(ErrorCode::bad_input, fmt::format("the scene has no L-system '{}'", wanted), {},
                suggestion(wanted, names));
  if (names.size() > 1)
    throw Error(ErrorCode::bad_input,
                fmt::format("the scene has several L-systems: {}", fmt::join(names, ", ")), {},
                "add one of these names after the scene");
  return shot.lsystems.front();
}

/// Number of modules of each name.
std::map<std::string, size_t> counts(const lsystem::Word& word, const lsystem::Alphabet& alphabet) {
  std::vector<size_t> by_symbol(alphabet.size());
  for (const lsystem::SymbolId symbol : word.symbols()) ++by_symbol[symbol];
  std::map<std::string, size_t> out;
  for (size_t id = 0; id < by_symbol.size(); ++id)
    if (by_symbol[id] > 0) out[alphabet.name(static_cast<lsystem::SymbolId>(id))] += by_symbol[id];
  return out;
}

/// Passes the text of the word to `take` in chunks.
template <class Take>
void for_each_chunk(const lsystem::Word& word, const lsystem::Alphabet& alphabet,
                    const Take& take) {
  constexpr size_t kChunk = 1 << 16;
  for (size_t begin = 0; begin < word.size(); begin += kChunk)
    take(lsystem::to_string(word, alphabet, begin, std::min(word.size(), begin + kChunk)));
}

std::string hash_of_word(const lsystem::Word& word, const lsystem::Alphabet& alphabet) {
  Sha256 hash;
  for_each_chunk(word, alphabet, [&](const std::string& part) { hash.add(part); });
  return hash.hex();
}

void print_json(const DeriveOptions& options, const lsystem::System& system,
                const lsystem::Word& word) {
  Json out{{"grammar", system.name}};
  if (system.timed)
    out["time"] = options.time.value_or(system.time);
  else
    out["steps"] = options.steps.value_or(system.steps);
  out["modules"] = word.size();
  out["symbols"] = counts(word, system.alphabet);
  out["sha256"] = hash_of_word(word, system.alphabet);
  if (!options.count && !options.hash) out["word"] = lsystem::to_string(word, system.alphabet);
  fmt::print("{}\n", out.dump(2));
}

int run_derive(const DeriveOptions& options) {
  const loading::Loaded loaded = options.scene.load();
  const shot::LSystemPtr plan = select_lsystem(loaded.shot, options.grammar);
  const lsystem::System& system = *plan->system;
  if (system.timed ? options.steps.has_value() : options.time.has_value())
    throw Error(ErrorCode::bad_input,
                fmt::format("the L-system '{}' has {}", system.name,
                            system.timed ? "a time instead of steps" : "steps instead of a time"),
                {}, system.timed ? "write --time T" : "write --steps N");
  lsystem::Derivation derivation = plan->derive(options.steps, options.time);
  const lsystem::Word word =
      options.drawn ? plan->interpret(std::move(derivation)) : std::move(derivation.word);
  const lsystem::Alphabet& alphabet = system.alphabet;
  if (options.json) {
    print_json(options, system, word);
  } else if (options.count) {
    for (const auto& [name, count] : counts(word, alphabet)) fmt::print("{} {}\n", name, count);
    fmt::print("total {}\n", word.size());
  } else if (options.hash) {
    fmt::print("{}\n", hash_of_word(word, alphabet));
  } else {
    for_each_chunk(word, alphabet, [](const std::string& part) { fmt::print("{}", part); });
    fmt::print("\n");
  }
  return kDone;
}

}  // namespace

Verb derive_verb() {
  return {"derive", "Prints the word derived by an L-system of a scene.", [](CLI::App& app) {
            auto options = std::make_shared<DeriveOptions>();
            options->scene.add_to(app);
            app.add_option("grammar", options->grammar,
                           "Name of the L-system; required if there are several");
            auto* steps =
                app.add_option("--steps", options->steps, "Number of steps; default from the scene")
                    ->check(CLI::Range(0, 1000000));
            app.add_option("--time", options->time,
                           "Derivation time of a timed L-system; default from the scene")
                ->check(CLI::Range(0.0, 1e9))
                ->excludes(steps);
            app.add_flag(
                "--drawn", options->drawn,
                "Print the word as the turtle reads it: interpreted, with sub-systems inserted");
            auto* count =
                app.add_flag("--count", options->count, "Print the number of modules of each name");
            app.add_flag("--hash", options->hash,
                         "Print the SHA-256 of the printed word without its newline")
                ->excludes(count);
            app.add_flag("--json", options->json, "Machine-readable output: counts, hash and word");
            app.add_option("--threads", options->threads, "Number of threads; 0 uses all cores")
                ->check(CLI::Range(0, 1024));
            return [options] {
              return with_threads(options->threads, [&] { return run_derive(*options); });
            };
          }};
}

}  // namespace vug::cli
