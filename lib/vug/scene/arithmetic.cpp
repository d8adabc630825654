// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/scene/arithmetic.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::scene {

namespace {

using Vector = Value::Vector;

/// Maximum size of a text that an expression assembles.
constexpr size_t kMaxTextBytes = 1000000;

std::string type_of(Dimension dimension) { return Value(Number{0, dimension}).type_name(); }

bool is_finite(const Vec3d& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

Value checked(Number n, const FaultSite& site) {
  return std::isfinite(n.value) ? Value(n) : site.fault("the result is not a finite number");
}

Value checked(Vector v, const FaultSite& site) {
  return is_finite(v.value) ? Value(v) : site.fault("the result is not a finite vector");
}

std::string hint_for_product(Dimension a, Dimension b) {
  const Dimension divided = is_plain(a) ? b : a;
  return fmt::format("divide one of them by a unit first, e.g. {} / 1{}", is_plain(a) ? "b" : "a",
                     unit_of(divided));
}

std::string adding(char op) { return op == '+' ? "cannot add" : "cannot subtract"; }

Value power(Number a, Number b, const FaultSite& site) {
  if (!is_plain(b.dimension))
    return site.fault(
        fmt::format("an exponent must be a plain number, not {}", type_of(b.dimension)));
  const auto known = raised(a.dimension, b.value);
  if (!known)
    return site.fault(fmt::format("{} cannot be raised to this power", type_of(a.dimension)),
                      fmt::format("divide it by a unit first, e.g. (r / 1{}) ^ {}",
                                  unit_of(a.dimension), b.value));
  const Dimension dimension = *known;
  if (a.value < 0 && b.value != std::floor(b.value))
    return site.fault("a negative number cannot be raised to a fractional power");
  if (a.value == 0 && b.value < 0) return site.fault("division by zero");
  // Whole powers are computed by multiplication: exact if the result is representable.
  if (b.value == std::floor(b.value) && std::fabs(b.value) <= 64) {
    double result = 1;
    for (int i = 0; i < static_cast<int>(std::fabs(b.value)); ++i) result *= a.value;
    return checked({b.value < 0 ? 1 / result : result, dimension}, site);
  }
  return checked({a.value == 0 ? 0 : maths::pow(a.value, b.value), dimension}, site);
}

Value scaled(char op, const Vector& v, Number by, bool by_first, const FaultSite& site) {
  if (op == '/' && by_first) return site.fault("cannot divide by a vector");
  if (op == '^') return site.fault("a vector cannot be raised to a power");
  if (op != '*' && op != '/')
    return site.fault(fmt::format("{} a vector and {}", adding(op), type_of(by.dimension)));
  const auto dimension = product(v.dimension, by.dimension, op == '*' ? 1 : -1);
  if (!dimension)
    return site.fault(fmt::format("cannot {} a vector ({}) by {}",
                                  op == '*' ? "multiply" : "divide", to_string(v.dimension),
                                  type_of(by.dimension)));
  if (op == '/' && by.value == 0) return site.fault("division by zero");
  return checked(Vector{op == '*' ? v.value * by.value : v.value / by.value, *dimension}, site);
}

Value numbers(char op, Number a, Number b, const FaultSite& site) {
  if (op == '^') return power(a, b, site);
  if (op == '+' || op == '-') {
    if (!unify_dimensions(a, b, adding(op), site)) return {};
    return checked({op == '+' ? a.value + b.value : a.value - b.value, a.dimension}, site);
  }
  const auto dimension = product(a.dimension, b.dimension, op == '*' ? 1 : -1);
  if (!dimension)
    return site.fault(fmt::format("cannot {} {} by {}", op == '*' ? "multiply" : "divide",
                                  type_of(a.dimension), type_of(b.dimension)),
                      hint_for_product(a.dimension, b.dimension));
  if (op == '/' && b.value == 0) return site.fault("division by zero");
  return checked({op == '*' ? a.value * b.value : a.value / b.value, *dimension}, site);
}

Value vectors(char op, const Vector& a, const Vector& b, const FaultSite& site) {
  if (op != '+' && op != '-')
    return site.fault("vectors can only be added and subtracted", "see dot(a, b) and cross(a, b)");
  Number da{1, a.dimension}, db{1, b.dimension};
  if (a.value == Vec3d(0)) da.value = 0;
  if (b.value == Vec3d(0)) db.value = 0;
  if (!unify_dimensions(da, db, adding(op), site)) return {};
  return checked(Vector{op == '+' ? a.value + b.value : a.value - b.value, da.dimension}, site);
}

/// The text of a value that can be joined to another; nothing for other types.
std::optional<std::string> text_of(const Value& value) {
  if (const auto* text = value.get<std::string>()) return *text;
  if (const Number* number = value.get<Number>()) return shortest_text(*number);
  return std::nullopt;
}

/// A text and a text or number, one after the other.
std::optional<Value> joined(const Value& a, const Value& b, const FaultSite& site) {
  const auto first = text_of(a), second = text_of(b);
  if (!first || !second) return std::nullopt;
  if (const size_t size = first->size() + second->size(); size > kMaxTextBytes)
    return site.fault(
        fmt::format("the text would have {} bytes, more than {}", size, kMaxTextBytes));
  return Value(*first + *second);
}

}  // namespace

bool unify_dimensions(Number& a, Number& b, const std::string& doing, const FaultSite& site) {
  if (a.dimension == b.dimension) return true;
  Number* bare = a.dimension == Dimension::none   ? &a
                 : b.dimension == Dimension::none ? &b
                                                  : nullptr;
  if (!bare) {
    site.fault(fmt::format("{} {} and {}", doing, type_of(a.dimension), type_of(b.dimension)));
    return false;
  }
  const Dimension dimension = (bare == &a ? b : a).dimension;
  if (dimension == Dimension::angle && bare->value != 0) {
    site.fault(fmt::format("{} {} and {}", doing, type_of(a.dimension), type_of(b.dimension)),
               fmt::format("write {0}deg or {0}rad", bare->value));
    return false;
  }
  bare->dimension = dimension;
  return true;
}

std::optional<Value> arithmetic(char op, const Value& a, const Value& b, const FaultSite& site) {
  if (op == '&') return std::nullopt;
  const Number* na = a.get<Number>();
  const Number* nb = b.get<Number>();
  const Vector* va = a.get<Vector>();
  const Vector* vb = b.get<Vector>();
  if (na && nb) return numbers(op, *na, *nb, site);
  if (va && vb) return vectors(op, *va, *vb, site);
  if (va && nb) return scaled(op, *va, *nb, false, site);
  if (na && vb) return scaled(op, *vb, *na, true, site);
  return op == '+' ? joined(a, b, site) : std::nullopt;
}

std::optional<Value> negate(char op, const Value& a) {
  if (const Number* n = a.get<Number>())
    return Value(Number{op == '-' ? -n->value : n->value, n->dimension});
  if (const Vector* v = a.get<Vector>())
    return Value(Vector{op == '-' ? -v->value : v->value, v->dimension});
  return std::nullopt;
}

std::optional<Value> compare(const std::string& op, const Value& a, const Value& b,
                             const FaultSite& site) {
  const auto* na = a.get<Number>();
  const auto* nb = b.get<Number>();
  if (na && nb) {
    Number x = *na, y = *nb;
    if (!unify_dimensions(x, y, "cannot compare", site)) return Value();
    const double p = x.value, q = y.value;
    return Value(op == "<"    ? p < q
                 : op == "<=" ? p <= q
                 : op == ">"  ? p > q
                 : op == ">=" ? p >= q
                 : op == "==" ? p == q
                              : p != q);
  }
  if (op != "==" && op != "!=") return std::nullopt;
  const auto answer = [&](bool equal) { return Value(equal == (op == "==")); };
  if (const auto* x = a.get<bool>(), *y = b.get<bool>(); x && y) return answer(*x == *y);
  if (const auto* x = a.get<std::string>(), *y = b.get<std::string>(); x && y)
    return answer(*x == *y);
  if (const auto* x = a.get<Value::Name>(), *y = b.get<Value::Name>(); x && y)
    return answer(x->text == y->text);
  if (const auto* x = a.get<Vector>(), *y = b.get<Vector>(); x && y)
    return answer(x->value == y->value);
  return std::nullopt;
}

Value vector_of(std::vector<Number> parts, const FaultSite& site) {
  for (size_t i = 1; i < parts.size(); ++i) {
    // A dimension found later also applies to the plain numbers before it.
    for (size_t j = 0; j < i; ++j)
      if (!unify_dimensions(parts[j], parts[i], "a vector cannot mix", site)) return {};
  }
  if (parts.size() == 2) return List{parts[0], parts[1]};
  return Vector{Vec3d(parts[0].value, parts[1].value, parts[2].value), parts[0].dimension};
}

}  // namespace vug::scene
