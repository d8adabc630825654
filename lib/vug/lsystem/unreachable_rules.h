// Rules that are never taken, whatever the word.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/lsystem/system.h>

#include <set>

namespace vug::lsystem {

/// Warns of each rule of the book that others of its symbol always go before: behind one that
/// always fits, or, without a weight of its own, behind one that always fits with a weight above 0.
/// Those in `reported` (by index) are passed over; the others that are reported join them.
void warn_unreachable_rules(const System& system, const RuleBook& book, Diagnostics& diagnostics,
                            std::set<uint16_t>& reported);

}  // namespace vug::lsystem
