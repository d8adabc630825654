// SPDX-License-Identifier: Apache-2.0
// The readings of a leg in both directions.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/survey/measurement.h>

namespace vug::survey {

/// The readings of one quantity. Both have the sense of the leg, so that they agree without errors.
struct BothDirections {
  std::optional<Reading> fore;
  std::optional<Reading> back;

  /// The reading if there is only one.
  std::optional<Reading> one() const {
    if (fore && back) return std::nullopt;
    return fore ? fore : back;
  }
  /// The average if there are both, weighted by their variances, else the one that there is. Adds a
  /// warning at `where` if they differ by more than three standard deviations. `name` is the
  /// instrument for the warning.
  std::optional<Reading> combine(const char* name, const SourceLocation& where,
                                 Diagnostics& warnings) const;
  /// The same for bearings, of which the difference may contain whole turns.
  std::optional<Reading> combine_bearings(const SourceLocation& where, Diagnostics& warnings) const;
};

}  // namespace vug::survey
