// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parameter_synonyms.h>
#include <vug/base/pluralize.h>
#include <vug/base/schema.h>
#include <vug/base/srgb.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

namespace vug::detail {

namespace {

/// The location of the argument's name, at its start.
SourceLocation name_location(const Argument& argument) {
  const SourceLocation& where = argument.where;
  if (!where.has_end()) return where;
  return {where.file, where.line, where.column, where.line,
          where.column + static_cast<int>(argument.name.size())};
}

}  // namespace

std::vector<int> match_arguments(const KindInfo& kind, const Arguments& arguments,
                                 const SourceLocation& where, Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const ParamInfo& param : kind.params) names.push_back(param.name);
  std::vector<int> target(arguments.size(), -1);
  std::vector<bool> given(kind.params.size(), false);
  size_t next = 0;
  for (size_t i = 0; i < arguments.size(); ++i) {
    const Argument& argument = arguments[i];
    size_t slot = names.size();
    if (argument.name.empty()) {
      while (next < given.size() && given[next]) ++next;
      slot = next;
      if (slot == names.size())
        diagnostics.error(argument.where, fmt::format("too many arguments for '{}'", kind.name),
                          fmt::format("it takes at most {}", names.size()));
    } else {
      slot =
          static_cast<size_t>(std::find(names.begin(), names.end(), argument.name) - names.begin());
      if (slot == names.size()) {
        const std::string ours = parameter_for(argument.name, names);
        diagnostics.error(name_location(argument),
                          fmt::format("'{}' has no parameter '{}'", kind.name, argument.name),
                          suggestion(ours.empty() ? argument.name : ours, names));
      }
    }
    if (slot == names.size()) continue;
    if (given[slot]) {
      diagnostics.error(argument.where, fmt::format("'{}' is given twice", names[slot]));
      continue;
    }
    given[slot] = true;
    target[i] = static_cast<int>(slot);
  }
  for (size_t slot = 0; slot < names.size(); ++slot)
    if (kind.params[slot].required && !given[slot])
      diagnostics.error(where, fmt::format("'{}' needs '{}'", kind.name, names[slot]),
                        fmt::format("{}: {}", names[slot], kind.params[slot].doc));
  return target;
}

namespace {

/// The type of the given value, or the value itself if the type is not informative: 5.5 is a
/// number, but not a whole one.
std::string given_text(const Value& value, const std::string& expected) {
  const bool informative = expected.find("number") == std::string::npos || !value.get<Number>();
  return informative ? value.type_name() : to_string(value);
}

/// "1st", "2nd", "11th" for a 0-based index.
std::string ordinal(size_t index) {
  const size_t n = index + 1, last = n % 10;
  const bool teen = n / 10 % 10 == 1;
  return fmt::format("{}{}", n,
                     teen || last == 0 || last > 3 ? "th"
                     : last == 1                   ? "st"
                     : last == 2                   ? "nd"
                                                   : "rd");
}

/// The unit in which to write a quantity; empty for plain numbers.
std::string unit_hint(Dimension dimension) {
  if (dimension == Dimension::angle) return "write it in deg or rad";
  const std::string unit = unit_of(dimension);
  if (unit.empty()) return "write it as a number without a unit";
  return fmt::format("write it in {}{}", unit[0] == '/' ? "1" : "", unit);
}

/// Checks one number, called `what` in messages.
bool check_number(const ParamInfo& info, const std::string& what, double value, Dimension dimension,
                  const SourceLocation& where, Diagnostics& diagnostics) {
  if (!std::isfinite(value)) {
    diagnostics.error(where, fmt::format("{} is not a finite number", what));
    return false;
  }
  const bool bare = dimension == Dimension::none;
  if (bare && info.dimension == Dimension::angle && value != 0) {
    diagnostics.error(where, fmt::format("{} is an angle and needs a unit", what),
                      fmt::format("write {}deg or {}rad", value, value));
    return false;
  }
  if (!bare && dimension != info.dimension &&
      !(dimension == Dimension::ratio && info.dimension == Dimension::none)) {
    diagnostics.error(
        where,
        fmt::format("{} expects {}, not {}", what, Value(Number{0, info.dimension}).type_name(),
                    Value(Number{0, dimension}).type_name()),
        unit_hint(info.dimension));
    return false;
  }
  const bool low = value < info.min || (info.above_min && value == info.min);
  if (low || value > info.max) {
    // Bounds such as 1 to 1e7 years make no sense as percentages.
    const bool hundredths = dimension == Dimension::ratio && info.dimension == Dimension::none &&
                            info.max > 1 && (low ? info.min : info.max) != 0;
    const Dimension unit = bare || hundredths ? info.dimension : dimension;
    const char* side = !low ? "at most" : info.above_min ? "above" : "at least";
    std::string bound = quantity_text(low ? info.min : info.max, unit);
    std::string given = quantity_text(value, unit);
    if (given == bound && !(low && value == info.min)) {
      bound = exact_quantity_text(low ? info.min : info.max, unit);
      given = exact_quantity_text(value, unit);
    }
    if (hundredths) given = quantity_text(value, dimension);
    diagnostics.error(
        where, fmt::format("{} must be {} {}, not {}", what, side, bound, given),
        hundredths ? fmt::format("{} is {:g}; write a number without '%'", given, value) : "");
    return false;
  }
  return true;
}

/// The linear colour of 8-bit sRGB codes, which another program may have displayed; empty for
/// vectors that cannot be such codes.
std::string code_hint(const Vec3d& codes) {
  for (int channel = 0; channel < 3; ++channel)
    if (!(codes[channel] >= 0 && codes[channel] <= 255 &&
          codes[channel] == std::floor(codes[channel])))
      return "";
  const auto linear = [&](int channel) { return srgb_decode(codes[channel] / 255); };
  return fmt::format(
      "colours are linear, from 0 to 1: write srgb({}, {}, {}) or ({:.3f}, {:.3f}, {:.3f})",
      codes.x, codes.y, codes.z, linear(0), linear(1), linear(2));
}

bool check_value(const ParamInfo& info, const std::string& what, const Value& value,
                 const SourceLocation& where, Diagnostics& diagnostics) {
  if (const Number* n = value.get<Number>())
    return check_number(info, what, n->value, n->dimension, where, diagnostics);
  if (const auto* v = value.get<Value::Vector>()) {
    Diagnostics found;
    for (int axis = 0; axis < 3 && found.all().empty(); ++axis)
      check_number(info, what, v->value[axis], v->dimension, where, found);
    if (found.all().empty()) return true;
    const Diagnostic& fault = found.all().front();
    diagnostics.error(fault.where, fault.message,
                      info.max == 1 && fault.hint.empty() ? code_hint(v->value) : fault.hint);
    return false;
  }
  if (const List* list = value.get<List>())
    for (size_t i = 0; i < list->size(); ++i)
      if (!check_value(info, fmt::format("the {} of {}", ordinal(i), what), (*list)[i], where,
                       diagnostics))
        return false;
  return true;
}

/// A correction of a value whose type is not the expected one; empty if there is none.
std::string correction(const ParamInfo& info, const Value& given) {
  const Number* number = given.get<Number>();
  const bool is_whole = number && number->value == std::floor(number->value);
  if (is_whole && info.type == "whole number")
    return fmt::format("whole numbers reach from {} to {}", -std::numeric_limits<int>::max(),
                       std::numeric_limits<int>::max());
  const bool takes_vector = info.type.find("vector") != std::string::npos;
  if (const auto* name = given.get<Value::Name>(); name && takes_vector) {
    static const std::map<std::string, const char*> directions = {
        {"+X", "(1, 0, 0)"},  {"-X", "(-1, 0, 0)"}, {"+Y", "(0, 1, 0)"},
        {"-Y", "(0, -1, 0)"}, {"+Z", "(0, 0, 1)"},  {"-Z", "(0, 0, -1)"}};
    if (const auto found = directions.find(name->text); found != directions.end())
      return fmt::format("write {}", found->second);
  }
  if (!takes_vector && info.type.find("paint") == std::string::npos) return {};
  const auto* text = given.get<std::string>();
  const bool is_code = text && text->size() > 1 && text->front() == '#' &&
                       text->find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (is_code) return fmt::format("write srgb(\"{}\")", *text);
  return {};
}

}  // namespace

void report_type(const ParamInfo& info, const Argument& argument, int misfit,
                 Diagnostics& diagnostics) {
  const std::string hint =
      info.choices.empty() ? correction(info, argument.value) : suggestion("", info.choices);
  std::string found = "not " + given_text(argument.value, info.type);
  const SourceLocation* where = &argument.where;
  if (const List* list = argument.value.get<List>(); list && misfit >= 0) {
    const auto i = static_cast<size_t>(misfit);
    found = fmt::format("and the {} is {}", ordinal(i), given_text((*list)[i], info.type));
    if (argument.elements.size() == list->size()) where = &argument.elements[i];
  }
  diagnostics.error(
      *where, fmt::format("'{}' expects {}, {}", info.name, with_article(info.type), found), hint);
}

bool check_range(const ParamInfo& info, const Argument& argument, Diagnostics& diagnostics) {
  return check_value(info, fmt::format("'{}'", info.name), argument.value, argument.where,
                     diagnostics);
}

std::string default_text(const Value& value, Dimension dimension) {
  if (dimension == Dimension::none) return to_string(value);
  if (const Number* n = value.get<Number>()) return quantity_text(n->value, dimension);
  if (const auto* v = value.get<Value::Vector>())
    return fmt::format("({}, {}, {})", quantity_text(v->value.x, dimension),
                       quantity_text(v->value.y, dimension), quantity_text(v->value.z, dimension));
  if (const List* list = value.get<List>()) {
    std::vector<std::string> items;
    for (const Value& item : *list) items.push_back(default_text(item, dimension));
    return fmt::format("[{}]", fmt::join(items, ", "));
  }
  return to_string(value);
}

std::optional<std::filesystem::path> read_file_name(const Argument& argument) {
  const std::string* text = argument.value.get<std::string>();
  if (!text) return std::nullopt;
  const std::filesystem::path folder = std::filesystem::path(argument.where.file).parent_path();
  return (folder / *text).lexically_normal();  // an absolute name replaces the folder
}

}  // namespace vug::detail
