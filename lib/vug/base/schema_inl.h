// SPDX-License-Identifier: Apache-2.0
// Template definitions of schema.h, such as `bind`, which fills a parameter struct from arguments.
#pragma once

namespace vug {

namespace detail {

template <class T>
std::optional<T> read_argument(const Argument& argument) {
  if constexpr (std::is_same_v<T, std::filesystem::path>)
    return read_file_name(argument);
  else
    return ValueTraits<T>::read(argument.value);
}

/// Index of the first list element that is not a T; -1 if there is none.
template <class T>
struct MismatchedElement {
  static int find(const Value&) { return -1; }
};
template <class T>
struct MismatchedElement<std::vector<T>> {
  static int find(const Value& value) {
    const List* list = value.get<List>();
    for (size_t i = 0; list && i < list->size(); ++i)
      if (!ValueTraits<T>::read((*list)[i])) return static_cast<int>(i);
    return -1;
  }
};
template <class T>
struct MismatchedElement<std::optional<T>> : MismatchedElement<T> {};

}  // namespace detail

template <class P>
template <class T, class Base>
requires std::derived_from<P, Base> Schema<P>
&Schema<P>::param(std::string name, T Base::*member, ParamSpec spec) {
  ParamInfo info{
      std::move(name),
      ValueTraits<T>::type(),
      spec.dimension,
      std::move(spec.doc),
      spec.required ? "" : detail::default_text(ValueTraits<T>::write(P{}.*member), spec.dimension),
      spec.required,
      spec.min,
      spec.max,
      spec.above_min,
      {}};
  add(std::move(info),
      [member](P& p, const Argument& argument, const ParamInfo& self, Diagnostics& diagnostics) {
        auto value = detail::read_argument<T>(argument);
        if (!value)
          return detail::report_type(
              self, argument, detail::MismatchedElement<T>::find(argument.value), diagnostics);
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
    if (!given) return detail::report_type(self, argument, -1, diagnostics);
    for (const auto& [text, value] : names)
      if (text == given->text) {
        p.*member = value;
        return;
      }
    diagnostics.error(argument.where, "invalid value '" + given->text + "' for '" + self.name + "'",
                      suggestion(given->text, self.choices));
  });
  return *this;
}

template <class P>
std::optional<P> Schema<P>::bind(const Arguments& arguments, const SourceLocation& where,
                                 Diagnostics& diagnostics) const {
  P p{};
  Diagnostics own;
  const std::vector<int> target = detail::match_arguments(info_, arguments, where, own);
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (target[i] < 0) continue;
    const auto slot = static_cast<size_t>(target[i]);
    setters_[slot](p, arguments[i], info_.params[slot], own);
  }
  if constexpr (requires { p.fault(); })
    if (!own.has_errors())
      if (std::string fault = p.fault(); !fault.empty()) own.error(where, std::move(fault));
  diagnostics.append(own);
  return own.has_errors() ? std::nullopt : std::optional<P>(std::move(p));
}

}  // namespace vug
