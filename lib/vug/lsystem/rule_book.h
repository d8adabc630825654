// Rules in the order in which they are tried, and how each symbol's one is found.
#pragma once

#include <vug/lsystem/system.h>

namespace vug::lsystem {

/// Numbers the draws of all productions: none may decide twice. Number 0 chooses between rules with
/// weights; then come those of guards, weights and ages, all rules of a head in a row, as several
/// may be looked at; then those of the successor, from the same number on for each rule.
void number_draws(System& system);

/// The book of these productions, whose draws are numbered. Those that look around go first
/// (prusinkiewicz1990, section 1.8), else the order stays.
RuleBook rule_book(const System& system, const std::vector<uint16_t>& productions);

}  // namespace vug::lsystem
