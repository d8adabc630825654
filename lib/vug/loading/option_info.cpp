// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/option_info.h>

namespace vug::loading {

ParamInfo option_info(const std::string& name, const std::string& type, const std::string& doc) {
  ParamInfo info;
  info.name = name;
  info.type = type;
  info.doc = doc;
  return info;
}

ParamInfo choice_info(const std::string& name, std::vector<std::string> choices,
                      const std::string& fallback, const std::string& doc) {
  ParamInfo info = option_info(name, "name", doc);
  info.choices = std::move(choices);
  info.fallback = fallback;
  return info;
}

ParamInfo whole_info(const std::string& name, double min, double max, const std::string& fallback,
                     const std::string& doc) {
  ParamInfo info = option_info(name, "whole number", doc);
  info.min = min;
  info.max = max;
  info.fallback = fallback;
  return info;
}

}  // namespace vug::loading
