// SPDX-License-Identifier: Apache-2.0
// Rule books: rules in the order in which they are tried, and the selection method of each symbol.
#pragma once

#include <vug/lsystem/system.h>

namespace vug::lsystem {

/// Assigns a random number to each draw of all productions, so that none is used twice. Number 0
/// selects between weighted rules. The next ones are for guards, weights and ages, consecutively
/// for all rules of a head, because several may be evaluated; the successor's draws follow,
/// starting at the same number for each rule.
void number_draws(System& system);

/// The rule book of these productions, whose draws are numbered. Rules with a context come first
/// (prusinkiewicz1990, section 1.8); otherwise the order is kept.
RuleBook rule_book(const System& system, const std::vector<uint16_t>& productions);

}  // namespace vug::lsystem
