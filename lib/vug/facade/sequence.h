// SPDX-License-Identifier: Apache-2.0
// Sequences of sizes: absolute lengths, fractions of the whole, and proportions of the rest.
#pragma once

#include <vug/facade/split.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::facade {

struct SizedPart {
  std::optional<Number> size;  ///< Empty: an even share of the rest.
  PartRef part;
};

/// Reads `4m, Base, 1, Upper` as sized parts. `fault` is an error message if sizes and parts do not
/// alternate.
std::vector<SizedPart> sized_parts(const std::vector<SizeOrPart>& steps, std::string& fault);
/// That error message, or empty.
std::string fault_of(const std::vector<SizeOrPart>& steps);

/// True if no part has a size; the sizes are then free numbers.
bool all_free(const std::vector<SizedPart>& parts);

/// A single size in metres for a scope's extent: a length, or a fraction of the whole. Throws
/// Error(bad_input) for plain numbers, which are only meaningful relative to others.
double resolve_size(const Number& size, double extent);

/// Sizes in metres that add up to `extent`; parts without a size have even shares. Throws
/// Error(bad_input) if the parts do not fit, a part would be empty, or some of the extent is
/// unused.
std::vector<double> divide(const std::vector<SizedPart>& parts, double extent);

/// A layout of the parts in sequence along x, from the left, or along y, from the bottom.
Layout lay_out_row(const std::vector<SizeOrPart>& steps, bool along_x, double width, double height,
                   FreeNumbers& free);

/// Documentation of sizes, shared by splits.
constexpr const char* kSizesDoc =
    "A size precedes its part: a length, a percentage of the whole, or a plain number for a "
    "proportion of the rest. If no part has a size, all sizes are free.";

}  // namespace vug::facade
