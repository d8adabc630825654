// SPDX-License-Identifier: Apache-2.0
#include <vug/base/hyperbolic.h>
#include <vug/base/maths.h>
#include <vug/scene/colour_functions.h>
#include <vug/scene/function_arguments.h>
#include <vug/scene/list_functions.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::scene {

namespace {

using Result = std::optional<Value>;
using Vector = Value::Vector;

Value finite_number(double value, Dimension dimension, const FaultSite& site) {
  if (!std::isfinite(value)) return site.fault("the result is not a finite number");
  return Number{value, dimension};
}

template <double (*F)(double)>
Result plain(const Arguments& arguments, const FaultSite& site) {
  const auto n = numbers_of(arguments);
  if (n.size() != 1 || !is_plain(n[0])) return std::nullopt;
  return finite_number(F(n[0].value), Dimension::none, site);
}

template <double (*F)(double)>
Result of_angle(const Arguments& arguments, const FaultSite& site) {
  const auto n = numbers_of(arguments);
  if (n.size() != 1 || !is_angle(n[0])) return std::nullopt;
  return finite_number(F(n[0].value), Dimension::none, site);
}

double floor_of(double x) { return std::floor(x); }
double ceil_of(double x) { return std::ceil(x); }
double round_of(double x) { return std::floor(x + 0.5); }

Result absolute(const Arguments& arguments, const FaultSite&) {
  const auto n = numbers_of(arguments);
  if (n.size() != 1) return std::nullopt;
  return Value(Number{std::fabs(n[0].value), n[0].dimension});
}

Result root(const Arguments& arguments, const FaultSite& site) {
  const auto n = numbers_of(arguments);
  const auto dimension = n.size() == 1 ? raised(n[0].dimension, 0.5) : std::nullopt;
  if (!dimension) return std::nullopt;
  if (n[0].value < 0) return site.fault("the square root of a negative number");
  return Value(Number{std::sqrt(n[0].value), *dimension});
}

Result logarithm(const Arguments& arguments, const FaultSite& site) {
  const auto n = numbers_of(arguments);
  if (n.size() != 1 || !is_plain(n[0])) return std::nullopt;
  if (n[0].value <= 0) return site.fault("the logarithm of a number that is not positive");
  return Value(maths::log(n[0].value));
}

template <bool Sine>
Result arc(const Arguments& arguments, const FaultSite& site) {
  const auto n = numbers_of(arguments);
  if (n.size() != 1 || !is_plain(n[0])) return std::nullopt;
  if (std::fabs(n[0].value) > 1)
    return site.fault("the arcsine or arccosine of a number outside -1..1");
  const double other = std::sqrt(std::max(0.0, 1 - n[0].value * n[0].value));
  return Value(Number{Sine ? maths::atan2(n[0].value, other) : maths::atan2(other, n[0].value),
                      Dimension::angle});
}

Result arc_tangent(const Arguments& arguments, const FaultSite& site) {
  auto n = numbers_of(arguments);
  if (n.size() == 1 && is_plain(n[0])) n.push_back({1});
  if (n.size() != 2) return std::nullopt;
  if (!unify_all_dimensions(n, site)) return Value();
  return Value(Number{maths::atan2(n[0].value, n[1].value), Dimension::angle});
}

Result power_of(const Arguments& arguments, const FaultSite& site) {
  const auto n = numbers_of(arguments);
  return n.size() == 2 ? arithmetic('^', n[0], n[1], site) : std::nullopt;
}

Result modulo(const Arguments& arguments, const FaultSite& site) {
  auto n = numbers_of(arguments);
  if (n.size() != 2) return std::nullopt;
  if (!unify_all_dimensions(n, site)) return Value();
  if (n[1].value == 0) return site.fault("division by zero");
  const double whole = std::floor(n[0].value / n[1].value);
  return finite_number(n[0].value - n[1].value * whole, n[0].dimension, site);
}

Result clamp(const Arguments& arguments, const FaultSite& site) {
  auto n = numbers_of(arguments);
  if (n.size() != 3) return std::nullopt;
  if (!unify_all_dimensions(n, site)) return Value();
  if (n[1].value > n[2].value)
    return site.fault("the lower bound of 'clamp' exceeds the upper bound");
  return Value(Number{std::clamp(n[0].value, n[1].value, n[2].value), n[0].dimension});
}

Result mix(const Arguments& arguments, const FaultSite& site) {
  if (arguments.size() != 3 || !arguments[2].value.get<Number>()) return std::nullopt;
  for (const Argument& argument : arguments)
    if (!argument.name.empty()) return std::nullopt;
  const Value &a = arguments[0].value, &b = arguments[1].value, &t = arguments[2].value;
  const auto rest = arithmetic('-', Value(1), t, site);
  if (!rest || rest->empty()) return rest;
  const auto left = arithmetic('*', a, *rest, site);
  const auto right = arithmetic('*', b, t, site);
  if (!left || !right) return std::nullopt;
  if (left->empty() || right->empty()) return Value();
  return arithmetic('+', *left, *right, site);
}

const Vector* vector_at(const Arguments& arguments, size_t index) {
  return index < arguments.size() && arguments[index].name.empty()
             ? arguments[index].value.get<Vector>()
             : nullptr;
}

Result length(const Arguments& arguments, const FaultSite& site) {
  const Vector* v = vector_at(arguments, 0);
  if (arguments.size() != 1 || !v) return std::nullopt;
  return finite_number(v->value.length(), v->dimension, site);
}

Result normalize(const Arguments& arguments, const FaultSite& site) {
  const Vector* v = vector_at(arguments, 0);
  if (arguments.size() != 1 || !v) return std::nullopt;
  if (v->value.length() == 0) return site.fault("a vector of length 0 has no direction");
  return Value(Vector{v->value.normalized()});
}

template <bool Dot>
Result vector_product(const Arguments& arguments, const FaultSite& site) {
  const Vector* a = vector_at(arguments, 0);
  const Vector* b = vector_at(arguments, 1);
  if (arguments.size() != 2 || !a || !b) return std::nullopt;
  const auto dimension = product(a->dimension, b->dimension);
  if (!dimension)
    return site.fault("the product of these vectors has no dimension known here",
                      "divide one of them by a unit first, e.g. a / 1m");
  if (Dot) return finite_number(a->value.dot(b->value), *dimension, site);
  return Value(Vector{a->value.cross(b->value), *dimension});
}

std::vector<Function> number_functions() {
  return {
      {"abs", "a number", "absolute value", absolute},
      {"sqrt", "a plain number or an area", "square root", root},
      {"floor", "a plain number", "the whole number below", plain<floor_of>},
      {"ceil", "a plain number", "the whole number above", plain<ceil_of>},
      {"round", "a plain number", "the nearest whole number, halves upwards", plain<round_of>},
      {"sin", "an angle", "sine", of_angle<maths::sin>},
      {"cos", "an angle", "cosine", of_angle<maths::cos>},
      {"tan", "an angle", "tangent", of_angle<maths::tan>},
      {"asin", "a plain number", "the angle with this sine", arc<true>},
      {"acos", "a plain number", "the angle with this cosine", arc<false>},
      {"atan", "y, or y and x", "the angle of the point (x, y); x is 1 by default", arc_tangent},
      {"exp", "a plain number", "e to this power", plain<maths::exp>},
      {"log", "a plain number", "natural logarithm", logarithm},
      {"tanh", "a plain number", "hyperbolic tangent", plain<maths::tanh>},
      {"atanh", "a plain number between -1 and 1", "inverse hyperbolic tangent",
       plain<maths::atanh>},
      {"pow", "two numbers", "the first to the power of the second", power_of},
      {"mod", "two numbers", "the remainder of a division, with the divisor's sign", modulo},
      {"clamp", "three numbers", "the first, clamped to the range of the others", clamp},
      {"mix", "two numbers or vectors and a number", "a (1 - t) + b t", mix},
      {"length", "a vector", "its length", length},
      {"normalize", "a vector", "its direction", normalize},
      {"dot", "two vectors", "inner product", vector_product<true>},
      {"cross", "two vectors", "cross product", vector_product<false>},
  };
}

/// Names that other languages use, and those of this one.
constexpr std::pair<const char*, const char*> kOtherNames[] = {
    {"count", "len"}, {"size", "len"}, {"append", "concat"},    {"lerp", "mix"},
    {"fmod", "mod"},  {"rgb", "srgb"}, {"kelvin", "blackbody"}, {"arctan", "atan"},
};

std::vector<Function> all_functions() {
  std::vector<Function> all = number_functions();
  for (const auto& more : {list_functions(), colour_functions()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace

bool unify_all_dimensions(std::vector<Number>& all, const FaultSite& site) {
  for (size_t round = 0; round < 2; ++round)
    for (size_t i = 1; i < all.size(); ++i)
      if (!unify_dimensions(all[0], all[i], "cannot compare", site)) return false;
  return true;
}

const std::vector<Function>& functions() {
  static const std::vector<Function> all = all_functions();
  return all;
}

const Function* find_function(const std::string& name) {
  for (const Function& function : functions())
    if (name == function.name) return &function;
  return nullptr;
}

std::string name_in_this_language(const std::string& name) {
  for (const auto& [other, ours] : kOtherNames)
    if (name == other) return ours;
  return name;
}

}  // namespace vug::scene
