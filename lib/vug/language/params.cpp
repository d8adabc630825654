// SPDX-License-Identifier: Apache-2.0
#include <vug/language/number_literal.h>
#include <vug/language/params.h>
#include <vug/language/position.h>
#include <vug/scene/evaluator.h>
#include <vug/scene/resolver.h>
#include <vug/scene/text_at.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::language {
namespace {

bool is_whole_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("-0123456789") == std::string::npos;
}

double number_in(const Value& value) { return value.get<Number>()->value; }

}  // namespace

bool ParamSetting::has_slider() const {
  return value.get<Number>() && low.get<Number>() && high.get<Number>() &&
         number_in(low) < number_in(high);
}

double ParamSetting::fraction() const {
  const double at = (number_in(value) - number_in(low)) / (number_in(high) - number_in(low));
  return std::clamp(at, 0.0, 1.0);
}

std::vector<ParamSetting> params_of(const Analysis& analysis) {
  scene::Resolver without_objects;
  Diagnostics ignored;
  scene::Evaluator evaluator(analysis.document, without_objects, ignored);
  std::vector<ParamSetting> out;
  const auto text_of_expression = [&](const scene::ExprPtr& expression) {
    return std::string(scene::text_at(analysis.text, expression->extent));
  };
  for (const scene::ParamValue& each : evaluator.params()) {
    const scene::Param& param = *each.param;
    if (param.where.file != analysis.file || !param.value) continue;
    ParamSetting setting{param.name,  param.doc,  text_of_expression(param.value),
                         param.where, each.value, each.low,
                         each.high,   "",         false};
    if (param.low && param.high) {
      const std::string low = text_of_expression(param.low), high = text_of_expression(param.high);
      setting.range = low + ".." + high;
      setting.whole =
          is_whole_number(setting.text) && is_whole_number(low) && is_whole_number(high);
    }
    out.push_back(std::move(setting));
  }
  return out;
}

std::string slider_text(const ParamSetting& param, double fraction) {
  const double low = number_in(param.low), high = number_in(param.high);
  const double value = low + std::clamp(fraction, 0.0, 1.0) * (high - low);
  if (param.whole) return decimal_text(std::round(value), 0);
  const std::string unit_name = param.text.substr(unit_begin(param.text));
  const Number* now = param.value.get<Number>();
  const std::optional<Number> unit =
      scene::read_number(param.text) ? scene::read_number("1" + unit_name) : std::nullopt;
  if (!unit || unit->dimension != now->dimension || !(unit->value > 0))
    return quantity_text(value, now->dimension);
  const double step = (high - low) / kSliderSteps / unit->value;
  return decimal_text(value / unit->value, decimals_for(step)) + unit_name;
}

}  // namespace vug::language
