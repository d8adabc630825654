// SPDX-License-Identifier: Apache-2.0
// The parameter that selects the statistics of passage sizes.
#pragma once

#include <vug/network/section_statistics.h>

#include <string>
#include <utility>
#include <vector>

namespace vug::shot {

/// The names of network::section_models() and "usual", the defaults of SectionModel.
inline std::vector<std::pair<std::string, std::string>> section_model_names() {
  std::vector<std::pair<std::string, std::string>> names{{"usual", "usual"}};
  for (const network::NamedSectionModel& each : network::section_models())
    names.emplace_back(each.name, each.name);
  return names;
}

/// The statistics of that name.
inline network::SectionModel section_model(const std::string& name) {
  for (const network::NamedSectionModel& each : network::section_models())
    if (name == each.name) return each.model;
  return {};
}

}  // namespace vug::shot
