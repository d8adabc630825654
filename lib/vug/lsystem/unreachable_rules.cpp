// SPDX-License-Identifier: Apache-2.0
#include <vug/lsystem/unreachable_rules.h>

#include <fmt/format.h>

#include <optional>
#include <vector>

namespace vug::lsystem {

namespace {

std::optional<double> constant_of(const Program& program) {
  const bool constant = program.code.size() == 1 && program.code[0].op == Op::constant;
  return constant ? std::optional(program.code[0].value) : std::nullopt;
}

/// Whether `first` matches wherever `other` does; both are rules of the same symbol.
bool matches_before(const Production& first, const Production& other) {
  if (first.has_context()) return false;
  if (!first.guard.empty() && constant_of(first.guard).value_or(0) == 0) return false;
  if (first.after.empty()) return true;
  const std::optional<double> age = constant_of(first.after), later = constant_of(other.after);
  return age && later && *age <= *later;
}

bool never_weighs(const Production& p) { return constant_of(p.weight) == 0.0; }

/// The first rule in `before` that always takes precedence over `p`, or null.
const Production* hiding_rule(const Production& p, const std::vector<const Production*>& before) {
  bool joins = false;  // an earlier weighted choice may include `p`
  for (const Production* each : before) {
    const bool lot = !each->weight.empty();
    const bool alone = lot ? p.weight.empty() && constant_of(each->weight).value_or(0) > 0
                           : p.weight.empty() || !joins;
    if (alone && matches_before(*each, p)) return each;
    joins = joins || (lot && each->has_context() == p.has_context());
  }
  return nullptr;
}

}  // namespace

void warn_unreachable_rules(const System& system, const RuleBook& book, Diagnostics& diagnostics,
                            std::set<uint16_t>& reported) {
  for (const RuleSelection& symbol : book.symbols) {
    std::vector<const Production*> before;  // reachable rules
    for (uint32_t r = symbol.first; r < symbol.end; ++r) {
      const Production& p = system.productions[book.rules[r]];
      const Production* hides = hiding_rule(p, before);
      if (!hides) {
        if (!never_weighs(p)) before.push_back(&p);
        continue;
      }
      if (!reported.insert(book.rules[r]).second) continue;
      diagnostics.warning(
          p.where,
          fmt::format("this rule of '{}' is never applied: an earlier one always matches", p.text),
          fmt::format("the earlier one is at {}; {} for a random choice", to_string(hides->where),
                      hides->weight.empty() ? "write weights such as '@1'"
                                            : "give this rule a weight, too,"));
    }
  }
}

}  // namespace vug::lsystem
