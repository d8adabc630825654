// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/evaluator.h>
#include <vug/scene/keys.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace vug::scene {
namespace {

/// Slope of a smooth curve at key i: the weighted harmonic mean of the slopes on both sides.
double slope(const std::vector<double>& frames, const std::vector<double>& values, size_t i) {
  if (i == 0 || i + 1 == frames.size()) return 0;
  const double before = frames[i] - frames[i - 1], after = frames[i + 1] - frames[i];
  const double a = (values[i] - values[i - 1]) / before, b = (values[i + 1] - values[i]) / after;
  if (!(a * b > 0)) return 0;
  const double share = (before + 2 * after) / (3 * (before + after));
  return a * b / (share * b + (1 - share) * a);
}

std::optional<Ease> read_ease(const Expr& expr) {
  if (expr.kind != ExprKind::name) return std::nullopt;
  if (expr.text == "linear") return Ease::linear;
  if (expr.text == "smooth") return Ease::smooth;
  if (expr.text == "step") return Ease::step;
  return std::nullopt;
}

/// The frame number of an argument's name; nothing if it is a word.
std::optional<double> read_frame(const std::string& name) {
  char* end = nullptr;
  const double frame = std::strtod(name.c_str(), &end);
  return name.empty() || *end != 0 ? std::nullopt : std::optional(frame);
}

/// The three components of a vector, or a number as a single component.
std::vector<double> components_of(const Value& value) {
  if (const auto* n = value.get<Number>()) return {n->value};
  const auto* v = value.get<Value::Vector>();
  return v ? std::vector<double>{v->value.x, v->value.y, v->value.z} : std::vector<double>{};
}

/// A number with the dimension of the value; 0 is compatible with every dimension.
Number dimension_of(const Value& value) {
  if (const auto* n = value.get<Number>()) return *n;
  const auto& v = *value.get<Value::Vector>();
  return {v.value == Vec3d(0) ? 0.0 : 1.0, v.dimension};
}

}  // namespace

double interpolate_keys(const std::vector<double>& frames, const std::vector<double>& values,
                        Ease ease, double frame) {
  if (!(frame > frames.front())) return values.front();
  if (!(frame < frames.back())) return values.back();
  const auto after = std::upper_bound(frames.begin(), frames.end(), frame);
  const auto i = static_cast<size_t>(after - frames.begin()) - 1;
  if (ease == Ease::step) return values[i];
  const double span = frames[i + 1] - frames[i], t = (frame - frames[i]) / span;
  if (ease == Ease::linear) return values[i] * (1 - t) + values[i + 1] * t;
  const double rest = 1 - t;  // cubic Hermite basis
  return values[i] * rest * rest * (1 + 2 * t) + values[i + 1] * t * t * (1 + 2 * rest) +
         span * t * rest * (slope(frames, values, i) * rest - slope(frames, values, i + 1) * t);
}

/// keys(1: 0.5m, 24: 2m), keys(smooth, 1: a, 24: b): the value at the frame.
Value Evaluator::keys(const Expr& expr, const Context& context) {
  constexpr const char* kForm = "e.g. keys(1: 0.5m, 24: 2m) or keys(smooth, 1: 0m, 9: 1m)";
  resolver_.use_frame();
  Ease ease = Ease::linear;
  std::vector<double> frames;
  std::vector<Value> values;
  bool sound = true;
  for (size_t i = 0; i < expr.operands.size(); ++i) {
    const Operand& part = expr.operands[i];
    const FaultSite here{part.where, *diagnostics_};
    if (const auto named = part.name.empty() && i == 0 ? read_ease(*part.value) : std::nullopt) {
      ease = *named;
      continue;
    }
    const auto frame = read_frame(part.name);
    if (!frame) return here.fault("'keys' needs frames with their values", kForm);
    if (!frames.empty() && !(*frame > frames.back()))
      return here.fault(
          fmt::format("the key at frame {} comes after that at {}", *frame, frames.back()),
          "write keys in the order of their frames, one per frame");
    frames.push_back(*frame);
    values.push_back(evaluate(*part.value, context));
    sound = sound && !values.back().empty() && is_known(values.back(), *part.value);
  }
  if (frames.empty()) return site(expr).fault("'keys' needs at least one key", kForm);
  if (!sound) return {};
  if (ease == Ease::step) {
    size_t now = 0;
    while (now + 1 < frames.size() && frames[now + 1] <= options_.frame) ++now;
    return values[now];
  }
  const std::vector<double> first = components_of(values.front());
  if (first.empty())
    return site(expr).fault(
        fmt::format("{} cannot be interpolated", values.front().type_name()),
        "only numbers and vectors can be interpolated; write keys(step, ...) for others");
  Number common = dimension_of(values.front());
  for (size_t round = 0; round < 2; ++round)  // the first may be a plain number
    for (const Value& value : values) {
      if (components_of(value).size() != first.size())
        return site(expr).fault(fmt::format("keys cannot mix {} and {}", values.front().type_name(),
                                            value.type_name()));
      Number other = dimension_of(value);
      if (!unify_dimensions(common, other, "keys cannot mix", site(expr))) return {};
    }
  std::vector<double> at;
  for (size_t part = 0; part < first.size(); ++part) {
    std::vector<double> curve;
    for (const Value& value : values) curve.push_back(components_of(value)[part]);
    at.push_back(interpolate_keys(frames, curve, ease, options_.frame));
  }
  if (at.size() == 1) return Number{at[0], common.dimension};
  return Value::Vector{{at[0], at[1], at[2]}, common.dimension};
}

}  // namespace vug::scene
