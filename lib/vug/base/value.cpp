// SPDX-License-Identifier: Apache-2.0
#include <vug/base/value.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>

namespace vug {

struct Value::ListData {
  List items;
  size_t elements;  ///< See element_count.
};

Value::Value(std::string text) : data_(std::make_shared<const std::string>(std::move(text))) {}

Value::Value(List list) {
  size_t elements = 1;
  for (const Value& item : list) elements += item.element_count();
  data_ = std::make_shared<const ListData>(ListData{std::move(list), elements});
}

const List* Value::list() const {
  const auto* data = std::get_if<std::shared_ptr<const ListData>>(&data_);
  return data ? &(*data)->items : nullptr;
}

size_t Value::element_count() const {
  const auto* data = std::get_if<std::shared_ptr<const ListData>>(&data_);
  return data ? (*data)->elements : 1;
}

namespace {

std::string text_with_digits(double value, Dimension dimension, int digits) {
  if (value == 0) return "0";
  if (dimension == Dimension::angle) return fmt::format("{:.{}g}deg", value * 180 / kPi, digits);
  if (dimension == Dimension::ratio) return fmt::format("{:.{}g}%", value * 100, digits);
  return fmt::format("{:.{}g}{}", value, digits, unit_of(dimension));
}

}  // namespace

std::string quantity_text(double value, Dimension dimension) {
  return text_with_digits(value, dimension, 6);
}

std::string exact_quantity_text(double value, Dimension dimension) {
  return text_with_digits(value, dimension, 17);
}

namespace {

std::string noun_phrase(const std::string& noun) {
  const bool vowel = !noun.empty() && std::string("aeiou").find(noun[0]) != std::string::npos;
  return fmt::format("{} {}", vowel ? "an" : "a", noun);
}

struct TypeName {
  std::string operator()(std::monostate) const { return "nothing"; }
  std::string operator()(const Number& n) const {
    return n.dimension == Dimension::none ? "a number" : noun_phrase(to_string(n.dimension));
  }
  std::string operator()(const Value::Vector&) const { return "a vector"; }
  std::string operator()(bool) const { return "true or false"; }
  std::string operator()(const std::string&) const { return "a text"; }
  std::string operator()(const Value::Name& n) const {
    return fmt::format("the name '{}'", n.text);
  }
  std::string operator()(const List&) const { return "a list"; }
  std::string operator()(const Object& o) const { return noun_phrase(o.type); }
};

std::string number_text(double value, Dimension dimension) {
  return fmt::format("{}{}", value, unit_of(dimension));
}

/// The quantity in a unit of which `parts` make up `whole`; empty if 15 digits are not sufficient.
std::string text_in_unit(double value, double parts, double whole, const char* unit) {
  const std::string digits = fmt::format("{:.15g}", value * parts / whole);
  return std::strtod(digits.c_str(), nullptr) * whole / parts == value ? digits + unit : "";
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

std::string shortest_text(const Number& number) {
  std::string text;
  if (number.dimension == Dimension::angle) text = text_in_unit(number.value, 180, kPi, "deg");
  if (number.dimension == Dimension::ratio) text = text_in_unit(number.value, 100, 1, "%");
  return text.empty() ? number_text(number.value, number.dimension) : text;
}

}  // namespace vug
