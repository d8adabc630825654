// SPDX-License-Identifier: Apache-2.0
#include <vug/base/memory.h>
#include <vug/base/parallel.h>
#include <vug/lsystem/cut.h>
#include <vug/lsystem/prefault_pages.h>
#include <vug/lsystem/production_selector.h>
#include <vug/lsystem/random_numbers.h>
#include <vug/lsystem/resize_uninitialized.h>
#include <vug/lsystem/rewriting.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::lsystem {

namespace {

/// Modules per task; fixed, because reported errors depend on it.
constexpr size_t kChunk = 4096;

/// Modules per batch of random numbers: a few kilobytes.
constexpr size_t kBatch = 256;

void check_finite(const Production& p, const double* values, size_t count) {
  for (size_t k = 0; k < count; ++k) {
    if (std::isfinite(values[k])) continue;
    size_t module = 0;
    while (p.ends[module] <= k) ++module;
    const size_t first = module == 0 ? 0 : p.ends[module - 1];
    fail_invalid_number(p, fmt::format("parameter {} of module {}", k - first + 1, module + 1),
                        values[k]);
  }
}

/// Computes all values of a simple successor, with one instruction per value.
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

/// A part of the word and the position of its output.
struct Rewriter::Chunk {
  size_t begin = 0, end = 0;
  size_t modules = 0, values = 0;      ///< Size of its output.
  size_t to_module = 0, to_value = 0;  ///< Start of its output.
  bool applied = false;
};

void Rewriter::choose(const RuleBook& book, const ContextMatcher& around, Chunk& chunk,
                      uint32_t salt) {
  const Word& word = from_->word;
  ProductionSelector selector(system_, book, word, around);
  RandomNumbers draws(from_->key, salt);
  const double* numbers = nullptr;
  for (size_t i = chunk.begin; i < chunk.end; ++i) {
    if (system_.random && (i - chunk.begin) % kBatch == 0) {
      draws.clear();
      for (size_t k = i; k < std::min(i + kBatch, chunk.end); ++k)
        draws.request(from_->keys[k], book.symbols[word.symbol(k)].blocks);
      numbers = draws.generate();
    }
    const uint16_t choice = selector.choose(i, numbers);
    numbers += 2 * size_t{book.symbols[word.symbol(i)].blocks};
    choice_[i] = choice;
    if (choice == 0) {
      ++chunk.modules;
      chunk.values += system_.alphabet.parameters(word.symbol(i));
    } else {
      const Production& p = system_.productions[choice - 1u];
      chunk.modules += p.symbols.size();
      chunk.values += p.value_count();
      chunk.applied = true;
    }
  }
}

void Rewriter::write(const RuleBook& book, const ContextMatcher& around, const Chunk& chunk,
                     RewriteMode mode, uint32_t salt) {
  const Word& word = from_->word;
  ProgramScratch scratch(system_);
  RandomNumbers draws(from_->key, salt);
  const double* numbers = nullptr;
  const SymbolId* symbols = word.symbols().data();
  const uint32_t* starts = word.starts().data();
  const double* values = word.values().data();
  SymbolId* symbol = to_.word.symbols().data() + chunk.to_module;
  uint32_t* end = to_.word.starts().data() + chunk.to_module + 1;
  double* const first = to_.word.values().data();
  double* value = first + chunk.to_value;
  uint64_t* key = system_.random ? to_.keys.data() + chunk.to_module : nullptr;

  for (size_t i = chunk.begin; i < chunk.end; ++i) {
    if (key && (i - chunk.begin) % kBatch == 0) {
      draws.clear();
      for (size_t k = i; k < std::min(i + kBatch, chunk.end); ++k)
        if (choice_[k] > 0)
          draws.request(from_->keys[k], system_.productions[choice_[k] - 1u].blocks);
      numbers = draws.generate();
    }
    if (choice_[i] == 0) {
      *symbol++ = symbols[i];
      for (uint32_t v = starts[i]; v < starts[i + 1]; ++v) *value++ = values[v];
      *end++ = static_cast<uint32_t>(value - first);
      const bool waits = mode == RewriteMode::step && book.has(symbols[i]);
      if (key) *key++ = waits ? child_key(from_->keys[i], 0, salt) : from_->keys[i];
      continue;
    }
    const Production& p = system_.productions[choice_[i] - 1u];
    const double* formals = formals_at(p, word, i, around, scratch);
    const size_t count = p.value_count();
    if (p.simple) {
      write_simple(p, formals, value);
    } else if (p.in_place) {
      compute(p, p.values, formals, value, numbers);
    } else {
      compute(p, p.values, formals, scratch.values(), numbers);
      for (size_t k = 0; k < count; ++k) value[k] = scratch.values()[k];
    }
    double sum = 0;  // x - x is 0 only for finite numbers
    for (size_t k = 0; k < count; ++k) sum += value[k] - value[k];
    if (sum != 0) check_finite(p, value, count);
    if (!p.after.empty()) {
      const double surplus = formals[0] - single(p, p.after, formals, scratch, numbers);
      for (const uint32_t age : p.ages) value[age] += surplus;
    }
    numbers += 2 * size_t{p.blocks};
    const auto base = static_cast<uint32_t>(value - first);
    for (size_t k = 0; k < p.symbols.size(); ++k) {
      *symbol++ = p.symbols[k];
      *end++ = base + p.ends[k];
      if (key) *key++ = child_key(from_->keys[i], k + 1, salt);
    }
    value += count;
  }
}

/// Throws an error that names the production with the largest output, by modules or by values.
void Rewriter::refuse(const std::string& what, bool by_values) const {
  const auto size_of = [&](const Production& p) {
    return by_values ? p.value_count() : p.symbols.size();
  };
  std::vector<size_t> made(system_.productions.size() + 1, 0);
  for (const uint16_t choice : choice_)
    made[choice] += choice == 0 ? 0 : size_of(system_.productions[choice - 1u]);
  const auto most = static_cast<size_t>(std::max_element(made.begin(), made.end()) - made.begin());
  const Production& p = most == 0 ? system_.axiom : system_.productions[most - 1];
  throw Error(ErrorCode::too_large,
              fmt::format("grammar '{}' exceeds {}, {} of {} by the rule of '{}'", system_.name,
                          what, made[most], by_values ? "their parameters" : "them", p.text),
              p.where, "take fewer steps, add a guard that ends the growth, or raise 'limit'");
}

void Rewriter::require_capacity(size_t modules, size_t values) const {
  if (static_cast<int64_t>(modules) > system_.limit)
    refuse(fmt::format("its limit of {} modules: the next step makes {}", system_.limit, modules),
           false);
  constexpr uint64_t kLittle = uint64_t{256} << 20;  // no check of the available memory below
  const uint64_t each = sizeof(SymbolId) + sizeof(uint32_t) + sizeof(uint16_t) +
                        (system_.random ? sizeof(uint64_t) : 0);
  const uint64_t bytes = modules * each + values * sizeof(double);
  if (!memory_ && bytes <= kLittle) return;
  const uint64_t most = memory_ ? *memory_ : available_memory();
  if (bytes > most)
    refuse(fmt::format("the memory of {}: the next step makes {} modules in {}",
                       bytes_text(static_cast<double>(most)), modules,
                       bytes_text(static_cast<double>(bytes))),
           values > 0);
}

const Production* Rewriter::applied() const {
  const auto one = std::find_if(choice_.begin(), choice_.end(), [](auto each) { return each > 0; });
  return one == choice_.end() ? nullptr : &system_.productions[*one - 1u];
}

void Rewriter::start(Derivation& out, std::optional<uint64_t> key) const {
  const Production& axiom = system_.axiom;
  ProgramScratch scratch(system_);
  out.word.clear();
  out.keys.clear();
  out.key = key.value_or(system_.key);
  RandomNumbers draws(out.key, 0);
  draws.request(out.key, axiom.blocks);
  compute(axiom, axiom.values, nullptr, scratch.values(), draws.generate());
  check_finite(axiom, scratch.values(), axiom.value_count());
  size_t value = 0;
  for (size_t k = 0; k < axiom.symbols.size(); ++k) {
    out.word.append(axiom.symbols[k], {scratch.values() + value, axiom.ends[k] - value});
    value = axiom.ends[k];
    if (system_.random) out.keys.push_back(child_key(out.key, k + 1, 0));
  }
  if (static_cast<int64_t>(out.word.size()) > system_.limit)
    throw Error(ErrorCode::too_large,
                fmt::format("grammar '{}' exceeds its limit of {} modules: its axiom has {}",
                            system_.name, system_.limit, out.word.size()),
                axiom.where, "raise 'limit'");
}

bool Rewriter::rewrite(const RuleBook& book, Derivation& word, RewriteMode mode, uint32_t salt) {
  if (system_.cut) cut_branches(system_, word);
  from_ = &word;
  const size_t size = word.word.size();
  resize_uninitialized(choice_, size);
  const auto memory = [](auto numbers) {
    return MemoryRange{numbers.data(), numbers.size_bytes()};
  };
  prefault_pages({memory(std::span(choice_))});
  const ContextMatcher around(system_, word.word, book.contexts);
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
  if (mode == RewriteMode::passing && !applied) return false;
  require_capacity(modules, values);
  to_.word.resize(modules, values);
  resize_uninitialized(to_.keys, system_.random ? modules : 0);
  to_.key = word.key;
  prefault_pages({memory(to_.word.symbols()), memory(to_.word.starts()), memory(to_.word.values()),
                  memory(std::span(to_.keys))});
  to_.word.starts()[0] = 0;
  parallel_for(chunks.size(), [&](size_t c) { write(book, around, chunks[c], mode, salt); });
  std::swap(word, to_);
  return applied;
}

}  // namespace vug::lsystem
