#include <vug/base/diagnostics.h>
#include <vug/base/value.h>
#include <vug/facade/free.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vug::facade {

namespace {

/// What rounding may add up to, of a length.
constexpr double kTiny = 1e-9;

std::string length_text(double metres) { return quantity_text(metres, Dimension::length); }

std::string text_of(const FreeNumber& asked, double value) {
  return asked.whole ? fmt::format("{:.6g}", value) : length_text(value);
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

Unfit::Unfit(Reason reason, std::string number, const std::string& message, std::string hint,
             SourceLocation where)
    : Error(ErrorCode::bad_input, message, std::move(where), std::move(hint)),
      reason_(reason),
      number_(std::move(number)) {}

const std::vector<double>* Free::told(const std::string& name) const {
  const auto found = told_.find(name);
  return found == told_.end() ? nullptr : &found->second;
}

void Free::refuse(const FreeNumber& asked, double value) const {
  const bool whole = !asked.whole || value == std::floor(value);
  const double slack = asked.whole ? 0 : kTiny * (1 + std::abs(value));
  if (whole && value >= asked.least - slack && value <= asked.most + slack) return;
  if (!whole || !std::isfinite(value))
    throw Unfit(Reason::does_not_fit, asked.name,
                fmt::format("'{}' is {}, not {:.6g}", asked.name,
                            asked.whole ? "a whole number" : "a length", value));
  throw Unfit(Reason::does_not_fit, asked.name,
              fmt::format("'{}' is {}", asked.name, text_of(asked, value)),
              asked.least > asked.most
                  ? "there is no room for any"
                  : fmt::format("here it is {} to {}", text_of(asked, asked.least),
                                text_of(asked, asked.most)));
}

int Free::count(const std::string& name, int least, int most, double usual,
                const std::function<int()>& draw) {
  if (drawn_) return draw();
  FreeNumber asked{.name = name,
                   .whole = true,
                   .least = static_cast<double>(least),
                   .most = static_cast<double>(most)};
  asked.values = {std::clamp(std::round(usual), asked.least, asked.most)};
  if (const auto* given = told(name)) {
    if (given->size() != 1)
      throw Unfit(Reason::does_not_fit, name, fmt::format("'{}' is one number", name));
    asked.values = *given;
    asked.told = true;
  }
  refuse(asked, asked.values[0]);
  asked_.push_back(asked);
  return static_cast<int>(asked.values[0]);
}

double Free::length(const std::string& name, double least, double most, double usual,
                    const std::function<double()>& draw) {
  if (drawn_) return draw();
  if (const auto* given = told(name); given && given->size() != 1)
    throw Unfit(Reason::does_not_fit, name, fmt::format("'{}' is one number", name));
  return lengths(name, "", 1, least, most, usual)[0];
}

std::vector<double> Free::lengths(const std::string& name, const std::string& per, size_t count,
                                  double least, double most, double usual) {
  FreeNumber asked{.name = name, .least = least, .most = most, .per = per};
  asked.values.assign(count, std::clamp(usual, std::min(least, most), most));
  if (const auto* given = told(name)) {
    if (given->size() > count)
      throw Unfit(Reason::does_not_fit, name,
                  fmt::format("'{}' are {} numbers, not {}", name, count, given->size()));
    std::copy(given->begin(), given->end(), asked.values.begin());
    if (!given->empty())
      std::fill(asked.values.begin() + static_cast<std::ptrdiff_t>(given->size()),
                asked.values.end(), given->back());
    asked.told = true;
  }
  for (const double value : asked.values) refuse(asked, value);
  asked_.push_back(asked);
  return asked.values;
}

std::vector<double> Free::shares(const std::string& name, const std::string& per, size_t count,
                                 double extent, RandomKey key, const std::vector<double>& usual) {
  if (drawn_) {
    RandomStream random(key);
    std::vector<double> sizes(count);
    for (double& size : sizes) size = random.uniform(0.5, 1.5);
    const double total = sum(sizes);
    for (double& size : sizes) size *= extent / total;
    return sizes;
  }
  FreeNumber asked{.name = name, .least = 0, .most = extent, .per = per};
  asked.values = usual;
  if (usual.empty()) asked.values.assign(count, extent / static_cast<double>(count));
  if (const auto* given = told(name)) {
    if (given->size() > count)
      throw Unfit(Reason::does_not_fit, name,
                  fmt::format("'{}' are {} numbers, not {}", name, count, given->size()));
    for (const double value : *given) refuse(asked, value);
    const double rest = extent - sum(*given), slack = 1e-6 * extent;
    const bool all = given->size() == count;
    if (all ? std::abs(rest) > slack : rest < -slack)
      throw Unfit(Reason::does_not_fit, name,
                  fmt::format("'{}' add up to {} of {}", name, length_text(extent - rest),
                              length_text(extent)),
                  "the last may be left out: it has the rest");
    asked.values = *given;
    asked.values.resize(count,
                        rest / static_cast<double>(std::max<size_t>(1, count - given->size())));
    if (all) asked.values.back() += rest;
    asked.told = true;
  }
  asked_.push_back(asked);
  return asked.values;
}

void Free::check_told() const {
  std::vector<std::string> known;
  for (const FreeNumber& asked : asked_) known.push_back(asked.name);
  for (const auto& [name, values] : told_)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw Unfit(Reason::does_not_fit, name, fmt::format("'{}' is no free number here", name),
                  known.empty() ? "the rule says all sizes itself" : suggestion(name, known));
}

}  // namespace vug::facade
