// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/cells/attributes.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::cells {

std::string_view name_of(CellState state) {
  constexpr std::string_view kNames[] = {"sleeping", "receiving", "distributing", "active",
                                         "transparent"};
  return kNames[static_cast<size_t>(state)];
}

std::string_view Attribute::type() const {
  constexpr std::string_view kNames[] = {"number", "vector", "whole number"};
  return kNames[column.index()];
}

const Attribute* Attributes::find(std::string_view name) const {
  const auto found = std::find_if(all_.begin(), all_.end(),
                                  [&](const Attribute& each) { return each.name == name; });
  return found == all_.end() ? nullptr : &*found;
}

const Attribute& Attributes::need(const std::string& name) const {
  if (const Attribute* known = find(name)) return *known;
  std::vector<std::string> known;
  for (const Attribute& each : all_) known.push_back(each.name);
  throw Error(ErrorCode::bad_input, fmt::format("cells have no attribute '{}'", name), {},
              suggestion(name, known));
}

void Attributes::refuse_type(const Attribute& known, std::string_view wanted) {
  throw Error(ErrorCode::bad_input, fmt::format("the attribute '{}' is a {}, not a {}", known.name,
                                                known.type(), wanted));
}

}  // namespace vug::cells
