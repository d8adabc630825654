// SPDX-License-Identifier: Apache-2.0
// Detection of rules that are never applied, whatever the word.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/lsystem/system.h>

#include <set>

namespace vug::lsystem {

/// Warns of each rule of the book that is always preceded by another rule of its symbol: one that
/// always matches, or, for a rule without a weight, one that always matches with a positive weight.
/// Skips the rules in `reported` (indices) and adds those that it reports.
void warn_unreachable_rules(const System& system, const RuleBook& book, Diagnostics& diagnostics,
                            std::set<uint16_t>& reported);

}  // namespace vug::lsystem
