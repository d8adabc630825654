#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/lsystem/context.h>
#include <vug/lsystem/cut.h>
#include <vug/lsystem/rewriting.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::lsystem {

namespace {

/// Modules of one task; fixed, as the results of faults depend on it.
constexpr size_t kChunk = 16384;

uint64_t salted(uint64_t key, uint64_t salt) {
  return salt == 0 ? key : RandomKey(key).at(~salt).state();
}

[[noreturn]] void no_number(const Production& production, const std::string& what, double value) {
  throw Error(ErrorCode::bad_input,
              fmt::format("{} of the rule of '{}' is {}", what, production.text, value),
              production.where, "numbers in words are finite");
}

/// Room for what a production's programs need at once.
struct Scratch {
  explicit Scratch(const System& system) {
    size_t formals = 0, values = 0;
    const auto add = [&](const Production& p) {
      size_t own = system.alphabet.size() > 0 ? Alphabet::kMostParameters : 0;
      for (const auto* side : {&p.left, &p.right})
        for (const ContextModule& module : *side)
          if (module.kind == ContextModule::Kind::module)
            own += system.alphabet.parameters(module.symbol);
      formals = std::max(formals, own);
      for (const Program* program : {&p.guard, &p.weight, &p.after, &p.values})
        values = std::max(values, static_cast<size_t>(program->depth));
    };
    add(system.axiom);
    for (const Production& p : system.productions) add(p);
    formals_.resize(formals);
    values_.resize(values + 1);
  }
  double* formals() { return formals_.data(); }
  double* values() { return values_.data(); }

 private:
  std::vector<double> formals_, values_;
};

/// The formals of production `p` at module `i`: without a context they lie in the word.
const double* formals_at(const Production& p, const Word& word, size_t i,
                         const Surroundings& around, Scratch& scratch) {
  if (!p.has_context()) return word.values().data() + word.starts()[i];
  around.match(p, i, scratch.formals());
  return scratch.formals();
}

double single(const Program& program, const double* formals, Scratch& scratch, uint64_t key) {
  run(program, formals, scratch.values(), key);
  return scratch.values()[0];
}

void check_finite(const Production& p, const double* values, size_t count) {
  for (size_t k = 0; k < count; ++k) {
    if (std::isfinite(values[k])) continue;
    size_t module = 0;
    while (p.ends[module] <= k) ++module;
    const size_t first = module == 0 ? 0 : p.ends[module - 1];
    no_number(p, fmt::format("parameter {} of module {}", k - first + 1, module + 1), values[k]);
  }
}

/// All values of the successor, each from one instruction.
void write_simple(const Production& p, const double* formals, double* out) {
  for (const Instruction& make : p.values.code) {
    switch (make.op) {
      case Op::formal:
        *out++ = formals[make.index];
        break;
      case Op::times_formal:
        *out++ = formals[make.index] * make.value;
        break;
      case Op::plus_formal:
        *out++ = formals[make.index] + make.value;
        break;
      default:
        *out++ = make.value;
    }
  }
}

}  // namespace

/// A part of the word, and what comes of it.
struct Rewriter::Chunk {
  size_t begin = 0, end = 0;
  size_t modules = 0, values = 0;      ///< How many it makes.
  size_t to_module = 0, to_value = 0;  ///< Where they go.
  bool applied = false;
};

void Rewriter::choose(const RuleBook& book, const Surroundings& around, Chunk& chunk,
                      uint64_t salt) {
  const Word& word = from_->word;
  Scratch scratch(system_);
  std::vector<std::pair<uint16_t, double>> lots;

  const auto fits = [&](const Production& p, size_t i, uint64_t key) {
    const double* formals = word.values().data() + word.starts()[i];
    if (p.has_context()) {
      if (!around.match(p, i, scratch.formals())) return false;
      formals = scratch.formals();
    }
    if (!p.after.empty()) {
      const double age = single(p.after, formals, scratch, key);
      if (std::isnan(age)) no_number(p, "the age", age);
      if (!(formals[0] >= age)) return false;
    }
    return p.guard.empty() || single(p.guard, formals, scratch, key) != 0;
  };
  const auto weigh = [&](const Production& p, size_t i, uint64_t key) {
    const double weight = single(p.weight, formals_at(p, word, i, around, scratch), scratch, key);
    if (!(weight >= 0) || std::isinf(weight)) no_number(p, "the weight", weight);
    return weight;
  };
  const auto pick = [&](size_t i) -> uint16_t {
    const uint32_t first = book.first[word.symbol(i)], end = book.first[word.symbol(i) + 1u];
    const uint64_t key = system_.random ? salted(from_->keys[i], salt) : 0;
    for (uint32_t r = first; r < end; ++r) {
      const Production& p = system_.productions[book.rules[r]];
      if (!fits(p, i, key)) continue;
      if (p.weight.empty()) return static_cast<uint16_t>(book.rules[r] + 1);
      lots.clear();
      double total = 0;
      for (uint32_t s = r; s < end; ++s) {
        const Production& other = system_.productions[book.rules[s]];
        if (other.weight.empty() || other.has_context() != p.has_context()) continue;
        if (s != r && !fits(other, i, key)) continue;
        total += weigh(other, i, key);
        lots.emplace_back(static_cast<uint16_t>(book.rules[s] + 1), total);
      }
      if (total == 0) return 0;
      const double dart = RandomStream(RandomKey(key)).uniform() * total;
      for (const auto& [choice, upto] : lots)
        if (dart < upto) return choice;
      return lots.back().first;
    }
    return 0;
  };

  for (size_t i = chunk.begin; i < chunk.end; ++i) {
    const SymbolId symbol = word.symbol(i);
    const uint16_t choice = book.has(symbol) ? pick(i) : uint16_t{0};
    choice_[i] = choice;
    if (choice == 0) {
      ++chunk.modules;
      chunk.values += system_.alphabet.parameters(symbol);
    } else {
      const Production& p = system_.productions[choice - 1u];
      chunk.modules += p.symbols.size();
      chunk.values += p.value_count();
      chunk.applied = true;
    }
  }
}

void Rewriter::write(const RuleBook& book, const Surroundings& around, const Chunk& chunk,
                     Mode mode, uint64_t salt) {
  const Word& word = from_->word;
  Scratch scratch(system_);
  const SymbolId* symbols = word.symbols().data();
  const uint32_t* starts = word.starts().data();
  const double* values = word.values().data();
  SymbolId* symbol = to_.word.symbols().data() + chunk.to_module;
  uint32_t* end = to_.word.starts().data() + chunk.to_module + 1;
  double* const first = to_.word.values().data();
  double* value = first + chunk.to_value;
  uint64_t* key = system_.random ? to_.keys.data() + chunk.to_module : nullptr;

  for (size_t i = chunk.begin; i < chunk.end; ++i) {
    if (choice_[i] == 0) {
      *symbol++ = symbols[i];
      for (uint32_t v = starts[i]; v < starts[i + 1]; ++v) *value++ = values[v];
      *end++ = static_cast<uint32_t>(value - first);
      const bool waits = mode == Mode::step && book.has(symbols[i]);
      if (key) *key++ = waits ? RandomKey(from_->keys[i]).at(uint64_t{0}).state() : from_->keys[i];
      continue;
    }
    const Production& p = system_.productions[choice_[i] - 1u];
    const uint64_t own = key ? salted(from_->keys[i], salt) : 0;
    const double* formals = formals_at(p, word, i, around, scratch);
    const size_t count = p.value_count();
    if (p.simple) {
      write_simple(p, formals, value);
    } else {
      run(p.values, formals, scratch.values(), own);
      std::copy_n(scratch.values(), count, value);
    }
    double sum = 0;  // finite numbers less themselves are 0
    for (size_t k = 0; k < count; ++k) sum += value[k] - value[k];
    if (sum != 0) check_finite(p, value, count);
    if (!p.after.empty()) {
      const double surplus = formals[0] - single(p.after, formals, scratch, own);
      for (const uint32_t age : p.ages) value[age] += surplus;
    }
    const auto base = static_cast<uint32_t>(value - first);
    for (size_t k = 0; k < p.symbols.size(); ++k) {
      *symbol++ = p.symbols[k];
      *end++ = base + p.ends[k];
      if (key) *key++ = RandomKey(own).at(k + 1).state();
    }
    value += count;
  }
}

/// Names the production that makes most of a word that is too large.
void Rewriter::refuse(size_t modules) const {
  std::vector<size_t> made(system_.productions.size() + 1, 0);
  for (const uint16_t choice : choice_)
    made[choice] += choice == 0 ? 0 : system_.productions[choice - 1u].symbols.size();
  const auto most = static_cast<size_t>(std::max_element(made.begin(), made.end()) - made.begin());
  const Production& p = most == 0 ? system_.axiom : system_.productions[most - 1];
  throw Error(
      ErrorCode::too_large,
      fmt::format("grammar '{}' exceeds its limit of {} modules: the next step makes {}, {} "
                  "of them by the rule of '{}'",
                  system_.name, system_.limit, modules, made[most], p.text),
      p.where, "take fewer steps, let a guard end the growth, or raise 'limit'");
}

void Rewriter::start(Derivation& out) const {
  const Production& axiom = system_.axiom;
  Scratch scratch(system_);
  out.word.clear();
  out.keys.clear();
  run(axiom.values, nullptr, scratch.values(), system_.key);
  check_finite(axiom, scratch.values(), axiom.value_count());
  size_t value = 0;
  for (size_t k = 0; k < axiom.symbols.size(); ++k) {
    out.word.append(axiom.symbols[k], {scratch.values() + value, axiom.ends[k] - value});
    value = axiom.ends[k];
    if (system_.random) out.keys.push_back(RandomKey(system_.key).at(k + 1).state());
  }
}

bool Rewriter::rewrite(const RuleBook& book, Derivation& word, Mode mode, uint64_t salt) {
  if (system_.cut) cut_branches(system_, word);
  from_ = &word;
  const size_t size = word.word.size();
  choice_.resize(size);
  const Surroundings around(system_, word.word, book.contexts);
  std::vector<Chunk> chunks((size + kChunk - 1) / kChunk);
  parallel_for(chunks.size(), [&](size_t c) {
    chunks[c].begin = c * kChunk;
    chunks[c].end = std::min(size, (c + 1) * kChunk);
    choose(book, around, chunks[c], salt);
  });
  size_t modules = 0, values = 0;
  bool applied = false;
  for (Chunk& chunk : chunks) {
    chunk.to_module = modules;
    chunk.to_value = values;
    modules += chunk.modules;
    values += chunk.values;
    applied = applied || chunk.applied;
  }
  if (mode == Mode::passing && !applied) return false;
  if (static_cast<int64_t>(modules) > system_.limit) refuse(modules);
  to_.word.resize(modules, values);
  to_.word.starts()[0] = 0;
  to_.keys.resize(system_.random ? modules : 0);
  parallel_for(chunks.size(), [&](size_t c) { write(book, around, chunks[c], mode, salt); });
  std::swap(word, to_);
  return applied;
}

}  // namespace vug::lsystem
