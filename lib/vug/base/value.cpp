// SPDX-License-Identifier: Apache-2.0
#include <vug/base/value.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace vug {

std::string to_string(Dimension dimension) {
  switch (dimension) {
    case Dimension::none:
      return "plain number";
    case Dimension::length:
      return "length";
    case Dimension::angle:
      return "angle";
    case Dimension::ratio:
      return "ratio";
    case Dimension::per_length:
      return "number per metre";
    case Dimension::time:
      return "time";
  }
  return {};
}

std::string quantity_text(double value, Dimension dimension) {
  if (value == 0) return "0";
  switch (dimension) {
    case Dimension::none:
      break;
    case Dimension::length:
      return fmt::format("{:.6g}m", value);
    case Dimension::angle:
      return fmt::format("{:.6g}deg", value * 180 / kPi);
    case Dimension::ratio:
      return fmt::format("{:.6g}%", value * 100);
    case Dimension::per_length:
      return fmt::format("{:.6g}/m", value);
    case Dimension::time:
      return fmt::format("{:.6g}s", value);
  }
  return fmt::format("{:.6g}", value);
}

namespace {

struct TypeName {
  std::string operator()(std::monostate) const { return "nothing"; }
  std::string operator()(const Number& n) const {
    switch (n.dimension) {
      case Dimension::none:
        return "a number";
      case Dimension::angle:
        return "an angle";
      case Dimension::per_length:
        return "a number per metre";
      default:
        return "a " + to_string(n.dimension);
    }
  }
  std::string operator()(const Value::Vector&) const { return "a vector"; }
  std::string operator()(bool) const { return "true or false"; }
  std::string operator()(const std::string&) const { return "a text"; }
  std::string operator()(const Value::Name& n) const {
    return fmt::format("the name '{}'", n.text);
  }
  std::string operator()(const List&) const { return "a list"; }
  std::string operator()(const Object& o) const {
    const bool vowel = !o.type.empty() && std::string("aeiou").find(o.type[0]) != std::string::npos;
    return fmt::format("{} {}", vowel ? "an" : "a", o.type);
  }
};

std::string number_text(double value, Dimension dimension) {
  switch (dimension) {
    case Dimension::length:
      return fmt::format("{}m", value);
    case Dimension::angle:
      return fmt::format("{}rad", value);
    case Dimension::time:
      return fmt::format("{}s", value);
    default:
      return fmt::format("{}", value);
  }
}

struct Text {
  std::string operator()(std::monostate) const { return ""; }
  std::string operator()(const Number& n) const { return number_text(n.value, n.dimension); }
  std::string operator()(const Value::Vector& v) const {
    return fmt::format("({}, {}, {})", number_text(v.value.x, v.dimension),
                       number_text(v.value.y, v.dimension), number_text(v.value.z, v.dimension));
  }
  std::string operator()(bool truth) const { return truth ? "true" : "false"; }
  std::string operator()(const std::string& text) const { return '"' + text + '"'; }
  std::string operator()(const Value::Name& name) const { return name.text; }
  std::string operator()(const List& list) const {
    std::vector<std::string> items;
    for (const Value& value : list) items.push_back(to_string(value));
    return fmt::format("[{}]", fmt::join(items, ", "));
  }
  std::string operator()(const Object& object) const { return fmt::format("<{}>", object.type); }
};

template <class Visitor>
std::string visit_value(const Value& value, const Visitor& visitor) {
  if (const auto* v = value.get<Number>()) return visitor(*v);
  if (const auto* v = value.get<Value::Vector>()) return visitor(*v);
  if (const auto* v = value.get<bool>()) return visitor(*v);
  if (const auto* v = value.get<std::string>()) return visitor(*v);
  if (const auto* v = value.get<Value::Name>()) return visitor(*v);
  if (const auto* v = value.get<List>()) return visitor(*v);
  if (const auto* v = value.get<Object>()) return visitor(*v);
  return visitor(std::monostate{});
}

}  // namespace

std::string Value::type_name() const { return visit_value(*this, TypeName{}); }

std::string to_string(const Value& value) { return visit_value(value, Text{}); }

}  // namespace vug
