// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/backsights.h>

#include <fmt/format.h>

namespace vug::survey {
namespace {

/// Standard deviations between two readings from which on a warning is due.
constexpr double kSuspicious = 3;

Reading checked(const Averaged& both, const char* name, const SourceLocation& where,
                Diagnostics& warnings) {
  if (both.disagreement > kSuspicious)
    warnings.warning(where,
                     fmt::format("the readings of the {} in both directions differ by "
                                 "{:.1f} standard deviations",
                                 name, both.disagreement),
                     "compare them with the notes: a reading may be wrong, or a number swapped");
  return both.reading;
}

}  // namespace

std::optional<Reading> BothDirections::combine(const char* name, const SourceLocation& where,
                                               Diagnostics& warnings) const {
  if (!fore || !back) return one();
  return checked(average(*fore, *back), name, where, warnings);
}

std::optional<Reading> BothDirections::combine_bearings(const SourceLocation& where,
                                                        Diagnostics& warnings) const {
  if (!fore || !back) return one();
  return checked(average_bearing(*fore, *back), "compass", where, warnings);
}

}  // namespace vug::survey
