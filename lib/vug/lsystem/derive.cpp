// SPDX-License-Identifier: Apache-2.0
#include <vug/base/rng.h>
#include <vug/lsystem/derive.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace vug::lsystem {

namespace {

/// Maximum number of rounds of non-terminating rules, and of modules that they visit: with large
/// words that many rounds would take minutes.
constexpr int kMaxRounds = 10000;
constexpr size_t kMaxModulesVisited = 2'000'000'000;

/// Counts the rounds and the visited modules of rules that may not terminate.
class RoundLimit {
 public:
  bool allows(const Derivation& word) {
    modules_visited_ += word.word.size();
    return rounds_++ < kMaxRounds && modules_visited_ < kMaxModulesVisited;
  }

 private:
  int rounds_ = 0;
  size_t modules_visited_ = 0;
};

constexpr uint32_t kDecomposing = 1, kInterpreting = 2;

[[noreturn]] void fail_nonterminating(const System& system, const Rewriter& rewriter,
                                      const std::string& what, int rounds,
                                      const std::string& hint) {
  const Production* rule = rewriter.applied();
  throw Error(
      ErrorCode::too_large,
      fmt::format("{} of grammar '{}' does not terminate after {} rounds{}", what, system.name,
                  rounds, rule ? fmt::format(", for instance the rule of '{}'", rule->text) : ""),
      rule ? rule->where : system.where, hint);
}

void apply_stage(const System& system, const Stage& stage, Rewriter& rewriter, Derivation& word,
                 uint32_t salt, Progress& progress) {
  if (stage.book.empty()) return;
  RoundLimit limit;
  for (int round = 0; !stage.depth || round < *stage.depth; ++round) {
    progress.check();
    if (!limit.allows(word))
      fail_nonterminating(system, rewriter,
                          salt == kDecomposing ? "the decomposition" : "the interpretation", round,
                          stage.depth ? "add a guard that ends it, or reduce 'depth'"
                                      : "add a guard that ends it, or set a 'depth'");
    if (!rewriter.rewrite(stage.book, word, RewriteMode::passing, salt)) return;
  }
}

/// Adds the whole time to all ages, then replaces all modules that are due.
void advance_time(const System& system, Rewriter& rewriter, Derivation& word, double time,
                  Progress& progress) {
  if (!(time >= 0) || std::isinf(time))
    throw Error(ErrorCode::bad_input,
                fmt::format("invalid time {} of grammar '{}'", time, system.name), system.where,
                "the time must be finite and at least 0");
  for (size_t i = 0; i < word.word.size(); ++i)
    if (system.ages[word.word.symbol(i)]) word.word.parameters(i)[0] += time;
  RoundLimit limit;
  for (int round = 0; rewriter.rewrite(system.books[0], word, RewriteMode::passing); ++round) {
    progress.check();
    if (!limit.allows(word))
      fail_nonterminating(system, rewriter, "the growth", round,
                          "successors must be younger than the age at which they are replaced");
  }
}

std::vector<size_t> queries_of(const System& system, const Word& word) {
  std::vector<size_t> places;
  for (size_t i = 0; i < word.size(); ++i)
    if (system.query[word.symbol(i)]) places.push_back(i);
  return places;
}

void answer_queries(const System& system, const DeriveOptions& options, Derivation& derivation,
                    Progress& progress) {
  const std::vector<size_t> asking = queries_of(system, derivation.word);
  if (asking.empty()) return;
  Word drawn = interpret(system, derivation, progress, options.memory);
  options.environment->answer(system, drawn);
  const std::vector<size_t> answered = queries_of(system, drawn);
  if (answered.size() != asking.size())
    throw Error(
        ErrorCode::bad_input,
        fmt::format("the interpretation of grammar '{}' creates or removes queries", system.name),
        system.where, "use queries only in rules outside of 'interpret'");
  for (size_t q = 0; q < asking.size(); ++q) {
    const std::span<const double> given = drawn.parameters(answered[q]);
    std::copy(given.begin(), given.end(), derivation.word.parameters(asking[q]).begin());
  }
}

/// Maximum number of steps that a module may request.
constexpr double kMaxSteps = 1e6;

/// The words of the systems that modules refer to, cached if they are not random.
class SubsystemWords {
 public:
  SubsystemWords(const System& outer, std::optional<uint64_t> memory, Progress& progress)
      : outer_(outer), memory_(memory), progress_(progress) {}

  const Word& of(const SubSystem& sub, std::span<const double> parameters, uint64_t key) {
    DeriveOptions options;
    options.memory = memory_;
    if (!parameters.empty()) {
      const double count = std::max(parameters[0], 0.0);
      if (count > kMaxSteps)
        throw Error(ErrorCode::too_large,
                    fmt::format("grammar '{}' requests {} steps of '{}'; the maximum is {}",
                                outer_.name, count, sub.system->name, kMaxSteps),
                    outer_.where);
      if (sub.system->timed)
        options.time = count;
      else
        options.steps = static_cast<int>(count);
    }
    const bool varies = sub.system->random && key != 0;
    if (!varies) {
      const auto known =
          words_.find({sub.system.get(), options.steps.value_or(-1), options.time.value_or(-1)});
      if (known != words_.end()) return known->second;
    }
    if (varies) options.key = RandomKey(key).at(sub.system->name).state();
    Word inner =
        interpret(*sub.system, derive(*sub.system, options, progress_), progress_, memory_);
    for (SymbolId& symbol : inner.symbols()) symbol = sub.symbols[symbol];
    if (varies) return last_ = std::move(inner);
    return words_[{sub.system.get(), options.steps.value_or(-1), options.time.value_or(-1)}] =
               std::move(inner);
  }

 private:
  const System& outer_;
  std::optional<uint64_t> memory_;
  Progress& progress_;
  std::map<std::tuple<const System*, int, double>, Word> words_;
  Word last_;
};

Word with_subsystems(const System& system, const Derivation& derivation,
                     std::optional<uint64_t> memory, Progress& progress) {
  SubsystemWords words(system, memory, progress);
  Word out;
  const Word& word = derivation.word;
  for (size_t i = 0; i < word.size(); ++i) {
    const auto sub = system.subsystems.find(word.symbol(i));
    if (sub == system.subsystems.end()) {
      out.append(word[i]);
      continue;
    }
    out.append(words.of(sub->second, word.parameters(i),
                        derivation.keys.empty() ? 0 : derivation.keys[i]));
    if (static_cast<int64_t>(out.size()) > system.limit)
      throw Error(ErrorCode::too_large,
                  fmt::format("grammar '{}' exceeds its limit of {} modules with the words of '{}'",
                              system.name, system.limit, sub->second.system->name),
                  system.where, "take fewer steps, or raise 'limit'");
  }
  return out;
}

}  // namespace

Derivation derive(const System& system, const DeriveOptions& options, Progress& progress) {
  Rewriter rewriter(system, options.memory);
  Derivation word;
  rewriter.start(word, options.key);
  if (system.timed) {
    advance_time(system, rewriter, word, options.time.value_or(system.time), progress);
    apply_stage(system, system.decompose, rewriter, word, kDecomposing, progress);
    return word;
  }
  const auto finish_step = [&] {
    apply_stage(system, system.decompose, rewriter, word, kDecomposing, progress);
    if (system.has_queries && options.environment) answer_queries(system, options, word, progress);
  };
  finish_step();
  const int steps = options.steps.value_or(system.steps);
  for (int step = 0; step < steps; ++step) {
    progress.check();
    const uint16_t book = system.schedule[static_cast<size_t>(step) % system.schedule.size()];
    rewriter.rewrite(system.books[book], word, RewriteMode::step);
    finish_step();
  }
  return word;
}

Word interpret(const System& system, Derivation derivation, Progress& progress,
               std::optional<uint64_t> memory) {
  Rewriter rewriter(system, memory);
  apply_stage(system, system.interpret, rewriter, derivation, kInterpreting, progress);
  if (system.subsystems.empty()) return std::move(derivation.word);
  return with_subsystems(system, derivation, memory, progress);
}

}  // namespace vug::lsystem
