// Templates of schema.h.
#pragma once

namespace vug {

template <>
struct ValueTraits<double> {
  static std::string type() { return "number"; }
  static std::optional<double> read(const Value& v) {
    const Number* n = v.get<Number>();
    return n ? std::optional(n->value) : std::nullopt;
  }
  static Value write(double v) { return v; }
};

template <>
struct ValueTraits<int> {
  static std::string type() { return "whole number"; }
  static std::optional<int> read(const Value& v) {
    const Number* n = v.get<Number>();
    if (!n || n->value != std::floor(n->value) || std::fabs(n->value) > 2147483647)
      return std::nullopt;
    return static_cast<int>(n->value);
  }
  static Value write(int v) { return v; }
};

template <>
struct ValueTraits<bool> {
  static std::string type() { return "true or false"; }
  static std::optional<bool> read(const Value& v) {
    const bool* b = v.get<bool>();
    return b ? std::optional(*b) : std::nullopt;
  }
  static Value write(bool v) { return v; }
};

template <>
struct ValueTraits<std::string> {
  static std::string type() { return "text"; }
  static std::optional<std::string> read(const Value& v) {
    const std::string* s = v.get<std::string>();
    return s ? std::optional(*s) : std::nullopt;
  }
  static Value write(const std::string& v) { return v; }
};

template <>
struct ValueTraits<Vec3d> {
  static std::string type() { return "vector"; }
  static std::optional<Vec3d> read(const Value& v) {
    const auto* vector = v.get<Value::Vector>();
    return vector ? std::optional(vector->value) : std::nullopt;
  }
  static Value write(const Vec3d& v) { return v; }
};

template <class T>
struct ValueTraits<std::optional<T>> {
  static std::string type() { return ValueTraits<T>::type(); }
  static std::optional<std::optional<T>> read(const Value& v) {
    const auto inner = ValueTraits<T>::read(v);
    return inner ? std::optional(inner) : std::nullopt;
  }
  static Value write(const std::optional<T>& v) { return v ? ValueTraits<T>::write(*v) : Value(); }
};

/// A list takes a list value; a single element stands for a list of one.
template <class T>
struct ValueTraits<std::vector<T>> {
  static std::string type() { return "list of " + ValueTraits<T>::type(); }
  static std::optional<std::vector<T>> read(const Value& v) {
    std::vector<T> out;
    if (const List* list = v.get<List>()) {
      for (const Value& item : *list) {
        auto element = ValueTraits<T>::read(item);
        if (!element) return std::nullopt;
        out.push_back(std::move(*element));
      }
      return out;
    }
    auto element = ValueTraits<T>::read(v);
    if (!element) return std::nullopt;
    out.push_back(std::move(*element));
    return out;
  }
  static Value write(const std::vector<T>& v) {
    List list;
    for (const T& item : v) list.push_back(ValueTraits<T>::write(item));
    return list;
  }
};

namespace detail {

inline bool check_range(const ParamInfo& info, const Argument& argument, Diagnostics& diagnostics) {
  if (const Number* n = argument.value.get<Number>())
    return check_number(info, n->value, n->dimension, argument.where, diagnostics);
  if (const auto* v = argument.value.get<Value::Vector>()) {
    for (int axis = 0; axis < 3; ++axis)
      if (!check_number(info, v->value[axis], v->dimension, argument.where, diagnostics))
        return false;
  }
  return true;
}

}  // namespace detail

template <class P>
template <class T>
Schema<P>& Schema<P>::param(std::string name, T P::*member, ParamSpec spec) {
  ParamInfo info{std::move(name),
                 ValueTraits<T>::type(),
                 spec.dimension,
                 std::move(spec.doc),
                 spec.required ? "" : to_string(ValueTraits<T>::write(P{}.*member)),
                 spec.required,
                 spec.min,
                 spec.max,
                 spec.above_min,
                 {}};
  add(std::move(info),
      [member](P& p, const Argument& argument, const ParamInfo& self, Diagnostics& diagnostics) {
        auto value = ValueTraits<T>::read(argument.value);
        if (!value) return detail::report_type(self, argument, diagnostics);
        if (detail::check_range(self, argument, diagnostics)) p.*member = std::move(*value);
      });
  return *this;
}

template <class P>
template <class E>
Schema<P>& Schema<P>::choice(std::string name, E P::*member,
                             std::vector<std::pair<std::string, E>> names, std::string doc) {
  ParamInfo info;
  info.name = std::move(name);
  info.type = "name";
  info.doc = std::move(doc);
  const P defaults{};
  for (const auto& [text, value] : names) {
    info.choices.push_back(text);
    if (value == defaults.*member) info.fallback = text;
  }
  add(std::move(info), [member, names](P& p, const Argument& argument, const ParamInfo& self,
                                       Diagnostics& diagnostics) {
    const auto* given = argument.value.get<Value::Name>();
    if (!given) return detail::report_type(self, argument, diagnostics);
    for (const auto& [text, value] : names)
      if (text == given->text) {
        p.*member = value;
        return;
      }
    diagnostics.error(argument.where, "'" + given->text + "' is no choice for '" + self.name + "'",
                      suggestion(given->text, self.choices));
  });
  return *this;
}

template <class P>
P Schema<P>::bind(const Arguments& arguments, SourceLocation where,
                  Diagnostics& diagnostics) const {
  P p{};
  const std::vector<int> target = detail::match_arguments(info_, arguments, where, diagnostics);
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (target[i] < 0) continue;
    const auto slot = static_cast<size_t>(target[i]);
    setters_[slot](p, arguments[i], info_.params[slot], diagnostics);
  }
  return p;
}

}  // namespace vug
