// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/lsystem/production_selector.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::lsystem {

ProgramScratch::ProgramScratch(const System& system) {
  size_t formals = 0, values = 0;
  const auto add = [&](const Production& p) {
    size_t own = system.alphabet.size() > 0 ? Alphabet::kMaxParameters : 0;
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

double* compute(const Production& production, const Program& program, const double* formals,
                double* stack, const double* numbers) {
  try {
    return run(program, formals, stack, numbers);
  } catch (const InvalidComparison& fault) {
    fail_invalid_number(production, "one side of a comparison", fault.value,
                        "check the divisor first: if x != 0 and 1 / x > 2");
  }
}

double single(const Production& production, const Program& program, const double* formals,
              ProgramScratch& scratch, const double* numbers) {
  compute(production, program, formals, scratch.values(), numbers);
  return scratch.values()[0];
}

const double* formals_at(const Production& p, const Word& word, size_t i,
                         const ContextMatcher& around, ProgramScratch& scratch) {
  if (!p.has_context()) return word.values().data() + word.starts()[i];
  around.match(p, i, scratch.formals());
  return scratch.formals();
}

void fail_invalid_number(const Production& production, const std::string& what, double value,
                         const std::string& hint) {
  throw Error(ErrorCode::bad_input,
              fmt::format("{} of the rule of '{}' is {}", what, production.text,
                          std::isnan(value) ? "not a number" : fmt::format("{}", value)),
              production.where, hint);
}

uint16_t ProductionSelector::choose(size_t i, const double* numbers) {
  const RuleSelection& symbol = book_.symbols[word_.symbol(i)];
  switch (symbol.how) {
    case RuleSelection::How::never:
      return 0;
    case RuleSelection::How::always:
      return static_cast<uint16_t>(book_.rules[symbol.first] + 1);
    case RuleSelection::How::weighted:
      return select_by_weight(symbol, numbers[0]);
    default:
      return select_first_match(symbol, i, numbers);
  }
}

uint16_t ProductionSelector::select_by_weight(const RuleSelection& symbol, double number) const {
  const double target = number * book_.cumulative_weights[symbol.end - 1];
  uint32_t rule = symbol.first;
  while (!(target < book_.cumulative_weights[rule]) && rule + 1 < symbol.end) ++rule;
  return static_cast<uint16_t>(book_.rules[rule] + 1);
}

bool ProductionSelector::fits(const Production& p, size_t i, const double* numbers) {
  const double* formals = word_.values().data() + word_.starts()[i];
  if (p.has_context()) {
    if (!around_.match(p, i, scratch_.formals())) return false;
    formals = scratch_.formals();
  }
  if (!p.after.empty()) {
    const double age = single(p, p.after, formals, scratch_, numbers);
    if (std::isnan(age)) fail_invalid_number(p, "the age", age);
    if (!(formals[0] >= age)) return false;
  }
  return p.guard.empty() || single(p, p.guard, formals, scratch_, numbers) != 0;
}

double ProductionSelector::weight(const Production& p, size_t i, const double* numbers) {
  const double* formals = formals_at(p, word_, i, around_, scratch_);
  const double weight = single(p, p.weight, formals, scratch_, numbers);
  if (weight < 0) fail_invalid_number(p, "the weight", weight, kWeights);
  if (!std::isfinite(weight)) fail_invalid_number(p, "the weight", weight);
  return weight;
}

uint16_t ProductionSelector::select_first_match(const RuleSelection& symbol, size_t i,
                                                const double* numbers) {
  for (uint32_t r = symbol.first; r < symbol.end; ++r) {
    const Production& p = system_.productions[book_.rules[r]];
    if (!fits(p, i, numbers)) continue;
    if (p.weight.empty()) return static_cast<uint16_t>(book_.rules[r] + 1);
    if (weight(p, i, numbers) == 0) continue;  // as if it did not match
    const double total = collect_weights(symbol, r, i, numbers);
    const double target = numbers[0] * total;
    for (const auto& [choice, upto] : weighted_)
      if (target < upto) return choice;
    return weighted_.back().first;
  }
  return 0;
}

/// Collects the cumulative weights of all matching rules from rule `r` on that have a context if
/// and only if it has one; returns their sum.
double ProductionSelector::collect_weights(const RuleSelection& symbol, uint32_t r, size_t i,
                                           const double* numbers) {
  const bool looks = system_.productions[book_.rules[r]].has_context();
  weighted_.clear();
  double total = 0;
  for (uint32_t s = r; s < symbol.end; ++s) {
    const Production& other = system_.productions[book_.rules[s]];
    if (other.weight.empty() || other.has_context() != looks) continue;
    if (s != r && !fits(other, i, numbers)) continue;
    const double own = weight(other, i, numbers);
    if (own == 0) continue;
    total += own;
    if (std::isinf(total))
      fail_invalid_number(other, "the sum of the weights up to that", total, kWeights);
    weighted_.emplace_back(static_cast<uint16_t>(book_.rules[s] + 1), total);
  }
  return total;
}

}  // namespace vug::lsystem
