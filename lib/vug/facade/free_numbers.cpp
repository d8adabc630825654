// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/base/value.h>
#include <vug/facade/free_numbers.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vug::facade {

namespace {

/// Relative tolerance of lengths for rounding.
constexpr double kLengthTolerance = 1e-9;

std::string text_of(const FreeNumber& request, double value) {
  return request.whole ? fmt::format("{:.6g}", value) : quantity_text(value, Dimension::length);
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

std::string to_string(Reason reason) {
  switch (reason) {
    case Reason::none:
      return "applies";
    case Reason::wrong_symbol:
      return "another symbol";
    case Reason::wrong_arguments:
      return "other arguments";
    case Reason::condition:
      return "condition is false";
    case Reason::does_not_fit:
      return "does not fit";
    case Reason::too_small:
      return "too small";
    case Reason::divided:
      return "divided already";
  }
  return "";
}

InfeasiblePlan::InfeasiblePlan(Reason reason, std::string number, const std::string& message,
                               std::string hint, SourceLocation where)
    : Error(ErrorCode::bad_input, message, std::move(where), std::move(hint)),
      reason_(reason),
      number_(std::move(number)) {}

const std::vector<double>* FreeNumbers::find_fixed(const std::string& name) const {
  const auto found = fixed_.find(name);
  return found == fixed_.end() ? nullptr : &found->second;
}

void FreeNumbers::refuse(const FreeNumber& request, double value) const {
  const bool whole = !request.whole || value == std::floor(value);
  const double slack = request.whole ? 0 : kLengthTolerance * (1 + std::abs(value));
  if (whole && value >= request.least - slack && value <= request.most + slack) return;
  if (!whole || !std::isfinite(value))
    throw InfeasiblePlan(Reason::does_not_fit, request.name,
                         fmt::format("'{}' is {}, not {:.6g}", request.name,
                                     request.whole ? "a whole number" : "a length", value));
  throw InfeasiblePlan(Reason::does_not_fit, request.name,
                       fmt::format("'{}' is {}", request.name, text_of(request, value)),
                       request.least > request.most ? "there is not enough space"
                                                    : fmt::format("it must be {} to {} here",
                                                                  text_of(request, request.least),
                                                                  text_of(request, request.most)));
}

int FreeNumbers::count(const std::string& name, int least, int most, double usual,
                       const std::function<int()>& draw) {
  if (random_) return draw();
  FreeNumber request{.name = name,
                     .whole = true,
                     .least = static_cast<double>(least),
                     .most = static_cast<double>(most)};
  request.values = {std::clamp(std::round(usual), request.least, request.most)};
  if (const auto* given = find_fixed(name)) {
    if (given->size() != 1)
      throw InfeasiblePlan(Reason::does_not_fit, name,
                           fmt::format("'{}' must be a single number", name));
    request.values = *given;
    request.fixed = true;
  }
  refuse(request, request.values[0]);
  requested_.push_back(request);
  return static_cast<int>(request.values[0]);
}

double FreeNumbers::length(const std::string& name, double least, double most, double usual,
                           const std::function<double()>& draw) {
  if (random_) return draw();
  if (const auto* given = find_fixed(name); given && given->size() != 1)
    throw InfeasiblePlan(Reason::does_not_fit, name,
                         fmt::format("'{}' must be a single number", name));
  return lengths(name, "", 1, least, most, usual)[0];
}

std::vector<double> FreeNumbers::lengths(const std::string& name, const std::string& per,
                                         size_t count, double least, double most, double usual) {
  FreeNumber request{.name = name, .least = least, .most = most, .per = per};
  request.values.assign(count, std::clamp(usual, std::min(least, most), most));
  if (const auto* given = find_fixed(name)) {
    if (given->size() > count)
      throw InfeasiblePlan(
          Reason::does_not_fit, name,
          fmt::format("'{}' must be {} numbers, not {}", name, count, given->size()));
    std::copy(given->begin(), given->end(), request.values.begin());
    if (!given->empty())
      std::fill(request.values.begin() + static_cast<std::ptrdiff_t>(given->size()),
                request.values.end(), given->back());
    request.fixed = true;
  }
  for (const double value : request.values) refuse(request, value);
  requested_.push_back(request);
  return request.values;
}

std::vector<double> FreeNumbers::shares(const std::string& name, const std::string& per,
                                        size_t count, double extent, RandomKey key,
                                        const std::vector<double>& usual) {
  if (random_) {
    RandomStream random(key);
    std::vector<double> sizes(count);
    for (double& size : sizes) size = random.uniform(0.5, 1.5);
    const double total = sum(sizes);
    for (double& size : sizes) size *= extent / total;
    return sizes;
  }
  FreeNumber request{.name = name, .least = 0, .most = extent, .per = per};
  request.values = usual;
  if (usual.empty()) request.values.assign(count, extent / static_cast<double>(count));
  if (const auto* given = find_fixed(name)) {
    if (given->size() > count)
      throw InfeasiblePlan(
          Reason::does_not_fit, name,
          fmt::format("'{}' must be {} numbers, not {}", name, count, given->size()));
    for (const double value : *given) refuse(request, value);
    const double rest = extent - sum(*given), slack = 1e-6 * extent;
    const bool all = given->size() == count;
    if (all ? std::abs(rest) > slack : rest < -slack)
      throw InfeasiblePlan(Reason::does_not_fit, name,
                           fmt::format("'{}' add up to {} of {}", name,
                                       quantity_text(extent - rest, Dimension::length),
                                       quantity_text(extent, Dimension::length)),
                           "omit the last one to give it the rest");
    request.values = *given;
    request.values.resize(count,
                          rest / static_cast<double>(std::max<size_t>(1, count - given->size())));
    if (all) request.values.back() += rest;
    request.fixed = true;
  }
  requested_.push_back(request);
  return request.values;
}

void FreeNumbers::check_all_used() const {
  std::vector<std::string> known;
  for (const FreeNumber& request : requested_) known.push_back(request.name);
  for (const auto& [name, values] : fixed_)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw InfeasiblePlan(
          Reason::does_not_fit, name, fmt::format("'{}' is not a free number here", name),
          known.empty() ? "the rule specifies all sizes" : suggestion(name, known));
}

}  // namespace vug::facade
