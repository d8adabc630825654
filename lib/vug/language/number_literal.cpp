// SPDX-License-Identifier: Apache-2.0
#include <vug/language/number_literal.h>
#include <vug/scene/text_at.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::language {
namespace {

constexpr int kMostDecimals = 9;

int decimals_of(const std::string& number) {
  const size_t point = number.find('.');
  if (point == std::string::npos) return 0;
  const size_t end = number.find_first_not_of("0123456789", point + 1);
  return static_cast<int>(std::min(end, number.size()) - point - 1);
}

}  // namespace

std::optional<NumberLiteral> number_literal(const Analysis& analysis, const scene::Expr& expr) {
  const bool sign = expr.kind == scene::ExprKind::unary && expr.text == "-";
  const scene::Expr& number = sign ? *expr.operands.at(0).value : expr;
  if (number.kind != scene::ExprKind::number || expr.extent.file != analysis.file ||
      !expr.extent.has_end())
    return std::nullopt;
  return NumberLiteral{expr.extent, std::string(scene::text_at(analysis.text, expr.extent)),
                       sign ? -number.number.value : number.number.value};
}

int decimals_for(double step) {
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step))), 0, kMostDecimals);
}

std::string decimal_text(double value, int decimals, int least) {
  std::string out = fmt::format("{:.{}f}", value, decimals);
  if (const size_t point = out.find('.'); point != std::string::npos) {
    const size_t kept = point + static_cast<size_t>(least);
    while (out.size() - 1 > kept && out.back() == '0') out.pop_back();
    if (out.back() == '.') out.pop_back();
  }
  const bool zero = out.find_first_not_of("-0.") == std::string::npos;
  return zero && out[0] == '-' ? out.substr(1) : out;
}

std::string number_text(const std::string& before, double value, double step,
                        const std::string& unit) {
  std::string own = before.substr(unit_begin(before));
  if (own.empty()) own = unit;
  const std::optional<Number> one = scene::read_number("1" + own);
  const double size = one && one->value > 0 ? one->value : 1;
  const int least = decimals_of(before);
  const int decimals = std::min(std::max(least, decimals_for(step / size)), kMostDecimals);
  return decimal_text(value / size, decimals, least) + own;
}

}  // namespace vug::language
