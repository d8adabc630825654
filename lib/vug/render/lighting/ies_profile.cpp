// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/render/lighting/ies_profile.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace vug::render {
namespace {

/// Reads the lines of a text and then its numbers; counts lines for messages.
class IesReader {
 public:
  IesReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(ErrorCode::bad_input,
                fmt::format("invalid IES file '{}': line {}: {}", name_, line_, what));
  }
  bool at_end() const { return at_ >= text_.size(); }
  std::string_view line() {
    const size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view out = text_.substr(at_, end - at_);
    while (!out.empty() && (out.back() == '\r' || out.back() == ' ')) out.remove_suffix(1);
    at_ = end + 1;
    ++line_;
    return out;
  }
  double number(const char* what) {
    const auto gap = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == ','; };
    while (!at_end() && (gap(text_[at_]) || text_[at_] == '\n'))
      if (text_[at_++] == '\n') ++line_;
    if (at_end()) fail(fmt::format("the text ends before {}", what));
    size_t end = at_;
    while (end < text_.size() && !gap(text_[end]) && text_[end] != '\n') ++end;
    std::string_view word = text_.substr(at_, end - at_);
    if (word.front() == '+') word.remove_prefix(1);
    double value = 0;
    const auto [past, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || past != word.data() + word.size() || !std::isfinite(value))
      fail(fmt::format("'{}' is not a number for {}", word.substr(0, 30), what));
    at_ = end;
    return value;
  }
  /// A whole number from `least` to `most`.
  size_t count(const char* what, size_t least, size_t most) {
    const double value = number(what);
    if (value != std::floor(value) || !(value >= static_cast<double>(least)) ||
        !(value <= static_cast<double>(most)))
      fail(fmt::format("{} is {}, but must be a whole number from {} to {}", what, value, least,
                       most));
    return static_cast<size_t>(value);
  }
  std::vector<double> angles(const char* what, size_t count, double least, double most) {
    std::vector<double> out;
    for (size_t i = 0; i < count; ++i) {
      out.push_back(number(what));
      if (!(out.back() >= least && out.back() <= most) || (i > 0 && !(out[i] > out[i - 1])))
        fail(fmt::format("{} must ascend from at least {} to at most {} degrees; found {}", what,
                         least, most, out.back()));
    }
    return out;
  }
  /// Numbers follow the next line break.
  void numbers_follow() { ++line_; }

 private:
  std::string_view text_;
  const std::string& name_;
  size_t at_ = 0;
  int line_ = 0;
};

/// The interval of an ascending table that contains x, and the position within it.
struct Between {
  size_t index;
  double part;
};
Between find(const std::vector<double>& table, double x) {
  if (table.size() < 2 || x <= table.front()) return {0, 0};
  if (x >= table.back()) return {table.size() - 2, 1};
  const auto next = std::upper_bound(table.begin(), table.end(), x);
  const auto index = static_cast<size_t>(next - table.begin()) - 1;
  return {index, (x - table[index]) / (table[index + 1] - table[index])};
}

}  // namespace

IesProfile::IesProfile(std::string_view text, const std::string& name) {
  IesReader in(text, name);
  std::string_view line = in.line();
  if (line.substr(0, 5) != "IESNA") in.fail("the file does not begin with IESNA");
  while (line.substr(0, 5) != "TILT=") {
    if (in.at_end()) in.fail("no line begins with TILT=");
    line = in.line();
  }
  if (line == "TILT=INCLUDE") {
    in.numbers_follow();
    in.number("the lamp position");
    const size_t pairs = in.count("the number of tilt angles", 1, 1000);
    for (size_t i = 0; i < 2 * pairs; ++i) in.number("a tilt angle or its factor");
  } else if (line == "TILT=NONE") {
    in.numbers_follow();
  } else {
    in.fail("only TILT=NONE and TILT=INCLUDE are supported");
  }
  const auto light_count = static_cast<double>(in.count("the number of lamps", 1, 10000));
  const double each = in.number("the lumen of a lamp");
  const double multiplier = in.number("the candela multiplier");
  const size_t verticals = in.count("the number of vertical angles", 2, 10000);
  const size_t horizontals = in.count("the number of horizontal angles", 1, 10000);
  if (verticals * horizontals > 4000000) in.fail("the file has more than four million intensities");
  if (in.count("the photometric type", 1, 3) != 1)
    in.fail("only type C photometry (1) is supported, not types B (2) and A (3)");
  in.count("the unit of length", 1, 2);
  for (const char* side : {"the width", "the length", "the height"}) in.number(side);
  const double ballast = in.number("the ballast factor");
  in.number("the reserved value");
  in.number("the input in watts");
  const double factor = multiplier * ballast;
  if (!(factor > 0)) in.fail("the product of multiplier and ballast factor must be above 0");
  rated_ = each > 0 ? light_count * each : -1;
  vertical_ = in.angles("vertical angles", verticals, 0, 180);
  horizontal_ = in.angles("horizontal angles", horizontals, 0, 360);
  if (horizontal_.front() != 0 && horizontals > 1)
    in.fail("the horizontal angles must begin with 0");
  const double last = horizontal_.back();
  if (horizontals > 1 && last != 90 && last != 180 && last != 360)
    in.fail(
        fmt::format("the horizontal angles end with {}, but must end with 90, 180 or 360", last));
  for (size_t i = 0; i < verticals * horizontals; ++i) {
    candela_.push_back(in.number("an intensity") * factor);
    if (!(candela_.back() >= 0)) in.fail("an intensity is below 0");
    peak_ = std::max(peak_, static_cast<float>(candela_.back()));
  }
  if (!(peak_ > 0)) in.fail("all intensities are 0");

  // Rings of an eighth of a degree, one sample per degree around; the integrand is piecewise
  // linear.
  constexpr int kRings = 1440, kTurns = 360;
  double lowest = 0;
  for (int i = 0; i < kRings; ++i) {
    const double v = (i + 0.5) * 180 / kRings, width = kPi / kRings;
    const double ring = maths::sin(v * kPi / 180) * width * 2 * kPi / kTurns;
    const bool even = horizontals == 1;
    double sum = 0;
    for (int j = 0; j < (even ? 1 : kTurns); ++j) sum += at(v, (j + 0.5) * 360 / kTurns);
    lumen_ += ring * sum * (even ? kTurns : 1);
    if (sum > 0) lowest = v;
  }
  lowest_cosine_ =
      static_cast<float>(maths::cos(std::min(180.0, lowest + 180.0 / kRings) * kPi / 180)) - 1e-5f;
}

/// In degrees; horizontal angles from 0 to 360.
double IesProfile::at(double vertical, double horizontal) const {
  if (vertical < vertical_.front() || vertical > vertical_.back()) return 0;
  const double last = horizontal_.back();
  if (last <= 180 && horizontal > 180) horizontal = 360 - horizontal;
  if (last <= 90 && horizontal > 90) horizontal = 180 - horizontal;
  const Between v = find(vertical_, vertical), h = find(horizontal_, horizontal);
  const auto value = [&](size_t row) {
    const double* from = candela_.data() + row * vertical_.size() + v.index;
    return from[0] * (1 - v.part) + from[1] * v.part;
  };
  if (horizontal_.size() == 1) return value(0);
  return value(h.index) * (1 - h.part) + value(h.index + 1) * h.part;
}

float IesProfile::candela(float down, float turn) const {
  const double cosine = std::clamp(static_cast<double>(down), -1.0, 1.0);
  const double around = static_cast<double>(turn - std::floor(turn)) * 360;
  return static_cast<float>(at(maths::acos(cosine) * 180 / kPi, around));
}

IesProfile read_ies(const std::filesystem::path& file) {
  return IesProfile(read_text(file), file.string());
}

}  // namespace vug::render
