// Sizes in a row: lengths, shares of the whole, shares of what is left.
#pragma once

#include <vug/facade/split.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::facade {

struct SizedPart {
  std::optional<Number> size;  ///< None: an even share of what is left.
  PartRef part;
};

/// `4m, Base, 1, Upper` as pairs. `fault` is a sentence where sizes and parts do not alternate.
std::vector<SizedPart> sized_parts(const std::vector<SizeOrPart>& steps, std::string& fault);
/// The same sentence alone; empty where they do.
std::string fault_of(const std::vector<SizeOrPart>& steps);

/// Whether no part has a size: the sizes are then free.
bool all_free(const std::vector<SizedPart>& parts);

/// A size on its own, of a scope's extent: a length, or a share of the whole. Error(bad_input) for
/// plain numbers, which only mean something beside others.
double resolve_size(const Number& size, double extent);

/// Sizes in metres that add up to `extent`; parts without any have even shares. Error(bad_input)
/// where parts do not fit, where a part would be empty, or where some of the extent is left over.
std::vector<double> divide(const std::vector<SizedPart>& parts, double extent);

/// The parts one behind the other along x, from the left, or along y, from the bottom.
Layout lay_out_row(const std::vector<SizeOrPart>& steps, bool along_x, double width, double height,
                   FreeNumbers& free);

/// What sizes before parts mean, for the documentation of splits.
constexpr const char* kSizesDoc =
    "A size stands before its part: a length, a share of the whole in per cent, or a number, a "
    "share of what is left. Without any size all are free.";

}  // namespace vug::facade
