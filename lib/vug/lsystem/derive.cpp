#include <vug/base/rng.h>
#include <vug/lsystem/derive.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace vug::lsystem {

namespace {

/// Rounds after which rules without an end are given up.
constexpr int kMostRounds = 10000;

constexpr uint32_t kDecomposing = 1, kInterpreting = 2;

[[noreturn]] void endless(const System& system, const RuleBook& book, const Derivation& word,
                          const std::string& what, const std::string& hint) {
  const auto fits = [&](SymbolId symbol) { return book.has(symbol); };
  const auto symbols = word.word.symbols();
  const auto one = std::find_if(symbols.begin(), symbols.end(), fits);
  const Production* rule = nullptr;
  if (one != symbols.end()) rule = &system.productions[book.rules[book.symbols[*one].first]];
  throw Error(ErrorCode::too_large,
              fmt::format("{} of grammar '{}' does not end after {} rounds{}", what, system.name,
                          kMostRounds,
                          rule ? fmt::format(", for instance the rule of '{}'", rule->text) : ""),
              rule ? rule->where : system.where, hint);
}

void pass(const System& system, const Stage& stage, Rewriter& rewriter, Derivation& word,
          uint32_t salt, Progress& progress) {
  if (stage.book.empty()) return;
  for (int round = 0; !stage.depth || round < *stage.depth; ++round) {
    progress.check();
    if (round >= kMostRounds)
      endless(system, stage.book, word,
              salt == kDecomposing ? "the decomposition" : "the interpretation",
              "let a guard end it, or give it a 'depth'");
    if (!rewriter.rewrite(stage.book, word, Mode::passing, salt)) return;
  }
}

/// Lets time go by at once, then catches up with what should have been replaced by then.
void age(const System& system, Rewriter& rewriter, Derivation& word, double time,
         Progress& progress) {
  if (!(time >= 0) || std::isinf(time))
    throw Error(ErrorCode::bad_input, fmt::format("the time {} of grammar '{}'", time, system.name),
                system.where, "time begins at 0");
  for (size_t i = 0; i < word.word.size(); ++i)
    if (system.ages[word.word.symbol(i)]) word.word.parameters(i)[0] += time;
  for (int round = 0; rewriter.rewrite(system.books[0], word, Mode::passing); ++round) {
    progress.check();
    if (round >= kMostRounds)
      endless(system, system.books[0], word, "the growth",
              "successors have to be younger than the age at which they are replaced");
  }
}

std::vector<size_t> queries_of(const System& system, const Word& word) {
  std::vector<size_t> places;
  for (size_t i = 0; i < word.size(); ++i)
    if (system.query[word.symbol(i)]) places.push_back(i);
  return places;
}

void ask(const System& system, const Environment& environment, Derivation& derivation,
         Progress& progress) {
  const std::vector<size_t> asking = queries_of(system, derivation.word);
  if (asking.empty()) return;
  Word drawn = interpreted(system, derivation, progress);
  environment.answer(system, drawn);
  const std::vector<size_t> answered = queries_of(system, drawn);
  if (answered.size() != asking.size())
    throw Error(
        ErrorCode::bad_input,
        fmt::format("the interpretation of grammar '{}' makes or loses queries", system.name),
        system.where, "queries stand in rules outside 'interpret'");
  for (size_t q = 0; q < asking.size(); ++q) {
    const std::span<const double> given = drawn.parameters(answered[q]);
    std::copy(given.begin(), given.end(), derivation.word.parameters(asking[q]).begin());
  }
}

/// The words of the systems that modules stand for, made once each where chance has no part.
class SubWords {
 public:
  explicit SubWords(Progress& progress) : progress_(progress) {}

  const Word& of(const SubSystem& sub, std::span<const double> parameters, uint64_t key) {
    DeriveOptions options;
    if (!parameters.empty()) {
      const double count = std::min(std::max(parameters[0], 0.0), 1e9);
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
    System own = *sub.system;
    if (varies) own.key = RandomKey(key).at(own.name).state();
    Word inner = interpreted(own, derive(own, options, progress_), progress_);
    for (SymbolId& symbol : inner.symbols()) symbol = sub.symbols[symbol];
    if (varies) return last_ = std::move(inner);
    return words_[{sub.system.get(), options.steps.value_or(-1), options.time.value_or(-1)}] =
               std::move(inner);
  }

 private:
  Progress& progress_;
  std::map<std::tuple<const System*, int, double>, Word> words_;
  Word last_;
};

Word with_subsystems(const System& system, const Derivation& derivation, Progress& progress) {
  SubWords words(progress);
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
  Rewriter rewriter(system);
  Derivation word;
  rewriter.start(word);
  if (system.timed) {
    age(system, rewriter, word, options.time.value_or(system.time), progress);
    pass(system, system.decompose, rewriter, word, kDecomposing, progress);
    return word;
  }
  const auto settle = [&] {
    pass(system, system.decompose, rewriter, word, kDecomposing, progress);
    if (system.asks && options.environment) ask(system, *options.environment, word, progress);
  };
  settle();
  const int steps = options.steps.value_or(system.steps);
  for (int step = 0; step < steps; ++step) {
    progress.check();
    const uint16_t book = system.schedule[static_cast<size_t>(step) % system.schedule.size()];
    rewriter.rewrite(system.books[book], word, Mode::step);
    settle();
  }
  return word;
}

Word interpreted(const System& system, Derivation derivation, Progress& progress) {
  Rewriter rewriter(system);
  pass(system, system.interpret, rewriter, derivation, kInterpreting, progress);
  if (system.subsystems.empty()) return std::move(derivation.word);
  return with_subsystems(system, derivation, progress);
}

}  // namespace vug::lsystem
