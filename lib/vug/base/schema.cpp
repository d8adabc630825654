#include <vug/base/schema.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::detail {

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
                          fmt::format("it takes {}", names.size()));
    } else {
      slot =
          static_cast<size_t>(std::find(names.begin(), names.end(), argument.name) - names.begin());
      if (slot == names.size())
        diagnostics.error(argument.where,
                          fmt::format("'{}' has no parameter '{}'", kind.name, argument.name),
                          suggestion(argument.name, names));
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
                        kind.params[slot].doc);
  return target;
}

void report_type(const ParamInfo& info, const Argument& argument, Diagnostics& diagnostics) {
  const std::string hint = info.choices.empty() ? std::string() : suggestion("", info.choices);
  diagnostics.error(
      argument.where,
      fmt::format("'{}' expects a {}, not {}", info.name, info.type, argument.value.type_name()),
      hint);
}

bool check_number(const ParamInfo& info, double value, Dimension dimension,
                  const SourceLocation& where, Diagnostics& diagnostics) {
  if (!std::isfinite(value)) {
    diagnostics.error(where, fmt::format("'{}' is not a finite number", info.name));
    return false;
  }
  const bool bare = dimension == Dimension::none;
  if (bare && info.dimension == Dimension::angle && value != 0) {
    diagnostics.error(where, fmt::format("'{}' is an angle and needs a unit", info.name),
                      fmt::format("write {}deg or {}rad", value, value));
    return false;
  }
  if (!bare && dimension != info.dimension &&
      !(dimension == Dimension::ratio && info.dimension == Dimension::none)) {
    diagnostics.error(where, fmt::format("'{}' expects {}, not {}", info.name,
                                         Value(Number{0, info.dimension}).type_name(),
                                         Value(Number{0, dimension}).type_name()));
    return false;
  }
  const bool low = value < info.min || (info.above_min && value == info.min);
  if (low || value > info.max) {
    const std::string bound =
        low ? fmt::format("{} {}", info.above_min ? "above" : "at least", info.min)
            : fmt::format("at most {}", info.max);
    diagnostics.error(where, fmt::format("'{}' must be {}, not {}", info.name, bound, value));
    return false;
  }
  return true;
}

std::optional<std::filesystem::path> read_file_name(const Argument& argument) {
  const std::string* text = argument.value.get<std::string>();
  if (!text) return std::nullopt;
  const std::filesystem::path folder = std::filesystem::path(argument.where.file).parent_path();
  return (folder / *text).lexically_normal();  // an absolute name replaces the folder
}

}  // namespace vug::detail
