// SPDX-License-Identifier: Apache-2.0
#include <vug/lsystem/random_numbers.h>
#include <vug/lsystem/rule_book.h>

#include <algorithm>
#include <cmath>

namespace vug::lsystem {

namespace {

bool is_draw(const Instruction& one) { return one.op == Op::draw || one.op == Op::choose; }

/// Numbers the draws of a program, starting after `last`; returns the last number used.
uint32_t number_program(Program& program, uint32_t last) {
  for (Instruction& one : program.code)
    if (is_draw(one)) one.index = ++last;
  return last;
}

/// Number of blocks that contain the program's draws.
uint32_t blocks_of(const Program& program) {
  uint32_t blocks = 0;
  for (const Instruction& one : program.code)
    if (is_draw(one)) blocks = std::max(blocks, blocks_with(one.index));
  return blocks;
}

/// The constant weight of a rule that always matches, or nothing.
std::optional<double> plain_weight(const Production& p) {
  const bool plain = p.guard.empty() && p.after.empty() && !p.has_context() &&
                     p.weight.code.size() == 1 && p.weight.code[0].op == Op::constant;
  if (!plain) return std::nullopt;
  const double weight = p.weight.code[0].value;
  return weight >= 0 && std::isfinite(weight) ? std::optional(weight) : std::nullopt;
}

RuleSelection rule_selection(const System& system, RuleBook& book, uint32_t first, uint32_t end) {
  RuleSelection out{first, end, 0, RuleSelection::How::never};
  if (first == end) return out;
  out.how = RuleSelection::How::sequential;
  const auto rule = [&](uint32_t r) -> const Production& {
    return system.productions[book.rules[r]];
  };
  uint32_t leads = first;  // the first applicable rule
  while (leads + 1 < end && plain_weight(rule(leads)) == 0.0) ++leads;
  bool lottery = !rule(leads).weight.empty();
  double total = 0;
  for (uint32_t r = first; r < end; ++r) {
    const Production& p = rule(r);
    for (const Program* program : {&p.guard, &p.weight, &p.after})
      out.blocks = std::max(out.blocks, blocks_of(*program));
    if (!p.weight.empty()) {
      out.blocks = std::max(out.blocks, blocks_with(0));
      lottery = lottery && plain_weight(p);
      total += plain_weight(p).value_or(0);
    }
    book.cumulative_weights[r] = total;
  }
  const Production& p = rule(first);
  if (lottery && total > 0 && std::isfinite(total)) out.how = RuleSelection::How::weighted;
  if (p.weight.empty() && p.guard.empty() && p.after.empty() && !p.has_context()) {
    out.how = RuleSelection::How::always;
    out.blocks = 0;
  }
  return out;
}

}  // namespace

void number_draws(System& system) {
  system.axiom.blocks = 0;
  number_program(system.axiom.values, 0);
  system.axiom.blocks = blocks_of(system.axiom.values);
  std::vector<uint32_t> last(system.alphabet.size(), 0);
  for (Production& p : system.productions)
    for (Program* program : {&p.guard, &p.weight, &p.after})
      last[p.head] = number_program(*program, last[p.head]);
  for (Production& p : system.productions) {
    number_program(p.values, last[p.head]);
    p.blocks = std::max(blocks_of(p.values), blocks_of(p.after));
  }
}

RuleBook rule_book(const System& system, const std::vector<uint16_t>& productions) {
  RuleBook out;
  std::vector<std::vector<uint16_t>> by_symbol(system.alphabet.size());
  const auto looks_around = [&](uint16_t rule) { return system.productions[rule].has_context(); };
  for (const uint16_t rule : productions) by_symbol[system.productions[rule].head].push_back(rule);
  out.cumulative_weights.resize(productions.size());
  for (std::vector<uint16_t>& rules : by_symbol) {
    std::stable_partition(rules.begin(), rules.end(), looks_around);
    const auto first = static_cast<uint32_t>(out.rules.size());
    out.rules.insert(out.rules.end(), rules.begin(), rules.end());
    const auto end = static_cast<uint32_t>(out.rules.size());
    out.symbols.push_back(rule_selection(system, out, first, end));
  }
  out.contexts = std::any_of(productions.begin(), productions.end(), looks_around);
  return out;
}

}  // namespace vug::lsystem
