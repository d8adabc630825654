// SPDX-License-Identifier: Apache-2.0
#include <vug/base/hyperbolic.h>
#include <vug/base/maths.h>
#include <vug/lsystem/program.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace vug::lsystem {

namespace {

double square_root(double x) { return std::sqrt(x); }
double absolute(double x) { return std::fabs(x); }
double floor_of(double x) { return std::floor(x); }
double ceil_of(double x) { return std::ceil(x); }
double round_of(double x) { return std::floor(x + 0.5); }
double arc_sine(double x) { return maths::atan2(x, std::sqrt((1 - x) * (1 + x))); }
double arc_tangent(double x) { return maths::atan2(x, 1); }
double least(double a, double b) { return std::min(a, b); }
double most(double a, double b) { return std::max(a, b); }
double clamped(double x, double low, double high) { return std::min(std::max(x, low), high); }
double mixed(double a, double b, double t) { return a + (b - a) * t; }
/// The remainder with the divisor's sign, like `mod` in scenes.
double modulo(double a, double b) { return a - b * std::floor(a / b); }

/// Whole powers are computed by multiplication, as in scene expressions: exact if representable.
double power(double base, double exponent) {
  if (exponent == std::floor(exponent) && std::fabs(exponent) <= 64) {
    double result = 1;
    for (int i = 0; i < static_cast<int>(std::fabs(exponent)); ++i) result *= base;
    return exponent < 0 ? 1 / result : result;
  }
  return base == 0 ? 0 : maths::pow(base, exponent);
}

/// Replaces top[-1] by holds(top[-1], *top).
template <class Holds>
void compare(double* top, const Holds& holds) {
  const double a = top[-1], b = *top;
  if ((a - a) + (b - b) != 0) throw InvalidComparison{std::isfinite(a) ? b : a};
  top[-1] = holds(a, b) ? 1 : 0;
}

}  // namespace

const std::vector<Function1>& functions1() {
  static const std::vector<Function1> all = {
      {"abs", absolute},     {"floor", floor_of},   {"ceil", ceil_of},      {"round", round_of},
      {"sqrt", square_root}, {"exp", maths::exp},   {"log", maths::log},    {"sin", maths::sin},
      {"cos", maths::cos},   {"tan", maths::tan},   {"asin", arc_sine},     {"acos", maths::acos},
      {"atan", arc_tangent}, {"tanh", maths::tanh}, {"atanh", maths::atanh}};
  return all;
}

const std::vector<Function2>& functions2() {
  static const std::vector<Function2> all = {
      {"min", least}, {"max", most}, {"mod", modulo}, {"pow", power}, {"atan", maths::atan2}};
  return all;
}

const std::vector<Function3>& functions3() {
  static const std::vector<Function3> all = {{"clamp", clamped}, {"mix", mixed}};
  return all;
}

double* run(const Program& program, const double* formals, double* top, const double* numbers) {
  const Instruction* const begin = program.code.data();
  const Instruction* const end = begin + program.code.size();
  // `top` points past the topmost number.
  for (const Instruction* at = begin; at != end; ++at) {
    switch (at->op) {
      case Op::constant:
        *top++ = at->value;
        break;
      case Op::formal:
        *top++ = formals[at->index];
        break;
      case Op::times_formal:
        *top++ = formals[at->index] * at->value;
        break;
      case Op::plus_formal:
        *top++ = formals[at->index] + at->value;
        break;
      case Op::negate:
        top[-1] = -top[-1];
        break;
      case Op::opposite:
        top[-1] = top[-1] == 0 ? 1 : 0;
        break;
      case Op::add:
        --top;
        top[-1] += *top;
        break;
      case Op::subtract:
        --top;
        top[-1] -= *top;
        break;
      case Op::multiply:
        --top;
        top[-1] *= *top;
        break;
      case Op::divide:
        --top;
        top[-1] /= *top;
        break;
      case Op::power:
        --top;
        top[-1] = power(top[-1], *top);
        break;
      case Op::less:
        compare(--top, std::less<>());
        break;
      case Op::less_equal:
        compare(--top, std::less_equal<>());
        break;
      case Op::greater:
        compare(--top, std::greater<>());
        break;
      case Op::greater_equal:
        compare(--top, std::greater_equal<>());
        break;
      case Op::equal:
        compare(--top, std::equal_to<>());
        break;
      case Op::unequal:
        compare(--top, std::not_equal_to<>());
        break;
      case Op::jump:
        at = begin + at->index - 1;
        break;
      case Op::jump_if_zero:
        if (*--top == 0) at = begin + at->index - 1;
        break;
      case Op::call1:
        top[-1] = functions1()[at->index].apply(top[-1]);
        break;
      case Op::call2:
        --top;
        top[-1] = functions2()[at->index].apply(top[-1], *top);
        break;
      case Op::call3:
        top -= 2;
        top[-1] = functions3()[at->index].apply(top[-1], top[0], top[1]);
        break;
      case Op::draw:
        --top;
        top[-1] += (*top - top[-1]) * numbers[at->index];
        break;
      case Op::choose:
        *top++ = std::floor(at->value * numbers[at->index]);
        break;
    }
  }
  return top;
}

}  // namespace vug::lsystem
