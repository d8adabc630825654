// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/sequence.h>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace vug::facade {

namespace {

/// Relative tolerance of an extent for rounding.
constexpr double kExtentTolerance = 1e-9;
/// Default height of a ground floor, metres.
constexpr double kStorey = 3.5;

std::string length_text(double metres) { return quantity_text(metres, Dimension::length); }

/// The parts with their sizes, e.g. "'Base' 4m, 'Cornice' 60cm".
std::string listed(const std::vector<SizedPart>& parts, const std::vector<double>& sizes) {
  std::string out;
  for (size_t i = 0; i < parts.size(); ++i)
    if (sizes[i] > 0)
      out += fmt::format("{}'{}' {}", out.empty() ? "" : ", ", parts[i].part.name,
                         length_text(sizes[i]));
  return out;
}

}  // namespace

std::vector<SizedPart> sized_parts(const std::vector<SizeOrPart>& steps, std::string& fault) {
  std::vector<SizedPart> out;
  std::optional<Number> size;
  for (const SizeOrPart& step : steps) {
    if (!step.is_part) {
      if (size) fault = "two consecutive sizes: each size must precede a part";
      if (!(step.size.value > 0)) fault = "a size must be above 0";
      size = step.size;
      continue;
    }
    out.push_back({size, step.part});
    size.reset();
  }
  if (size) fault = "the last size is not followed by a part";
  if (out.empty() && fault.empty()) fault = "there are no parts";
  return out;
}

std::string fault_of(const std::vector<SizeOrPart>& steps) {
  std::string fault;
  sized_parts(steps, fault);
  return fault;
}

bool all_free(const std::vector<SizedPart>& parts) {
  return std::none_of(parts.begin(), parts.end(),
                      [](const SizedPart& part) { return part.size.has_value(); });
}

double resolve_size(const Number& size, double extent) {
  if (size.dimension == Dimension::length) return size.value;
  if (size.dimension == Dimension::ratio) return size.value * extent;
  throw Error(ErrorCode::bad_input, fmt::format("the size {} has no unit", size.value), {},
              "write it in metres or as a percentage of the whole");
}

Layout lay_out_row(const std::vector<SizeOrPart>& steps, bool along_x, double width, double height,
                   FreeNumbers& free) {
  std::string none;
  const std::vector<SizedPart> all = sized_parts(steps, none);
  const double extent = along_x ? width : height;
  std::vector<double> usual;
  // The lower of two rows is usually a ground floor.
  if (!along_x && all.size() == 2 && extent > 2 * kStorey) usual = {kStorey, extent - kStorey};
  const std::vector<double> sizes =
      all_free(all) && all.size() > 1
          ? free.shares(along_x ? "widths" : "heights", "", all.size(), extent, free.key(), usual)
          : divide(all, extent);
  Layout out;
  double at = 0;
  for (size_t i = 0; i < all.size(); ++i) {
    out.cells.push_back(
        {.part = all[i].part.part,
         .rect = along_x ? Rect{at, 0, sizes[i], height} : Rect{0, at, width, sizes[i]},
         .given = {{along_x ? "width" : "height", sizes[i]}},
         .index = static_cast<int64_t>(i),
         .total = static_cast<int64_t>(all.size()),
         .column = along_x ? static_cast<int>(i) : 0,
         .row = along_x ? 0 : static_cast<int>(i)});
    at += sizes[i];
  }
  return out;
}

std::vector<double> divide(const std::vector<SizedPart>& parts, double extent) {
  std::vector<double> sizes(parts.size(), 0.0), shares(parts.size(), 0.0);
  for (size_t i = 0; i < parts.size(); ++i) {
    const Number size = parts[i].size.value_or(Number{1, Dimension::none});
    if (size.dimension == Dimension::length || size.dimension == Dimension::ratio)
      sizes[i] = resolve_size(size, extent);
    else if (size.dimension == Dimension::none)
      shares[i] = size.value;
    else
      throw Error(
          ErrorCode::bad_input,
          fmt::format("the size of '{}' is {}", parts[i].part.name, to_string(size.dimension)), {},
          "a size must be a length, a percentage or a number");
  }
  const double fixed = std::accumulate(sizes.begin(), sizes.end(), 0.0);
  const double total = std::accumulate(shares.begin(), shares.end(), 0.0);
  const double rest = extent - fixed;
  if (rest < -kExtentTolerance * extent)
    throw Error(ErrorCode::bad_input,
                fmt::format("the parts do not fit: they need {} of {} ({})", length_text(fixed),
                            length_text(extent), listed(parts, sizes)),
                {}, "make one of them a proportion of the rest: a number without a unit");
  if (total > 0 && rest <= kExtentTolerance * extent) {
    const size_t first = static_cast<size_t>(
        std::find_if(shares.begin(), shares.end(), [](double s) { return s > 0; }) -
        shares.begin());
    throw Error(ErrorCode::bad_input,
                fmt::format("nothing of {} is left for '{}' ({})", length_text(extent),
                            parts[first].part.name, listed(parts, sizes)));
  }
  if (total == 0 && rest > 1e-6 * extent)
    throw Error(ErrorCode::bad_input,
                fmt::format("{} of {} is unused ({})", length_text(rest), length_text(extent),
                            listed(parts, sizes)),
                {}, "make one of them a proportion of the rest: a number without a unit");
  for (size_t i = 0; i < parts.size(); ++i)
    if (shares[i] > 0) sizes[i] = rest * shares[i] / total;
  return sizes;
}

}  // namespace vug::facade
