// SPDX-License-Identifier: Apache-2.0
// The documentation of options that have no schema, such as those of grammars.
#pragma once

#include <vug/base/schema.h>

namespace vug::loading {

/// An option whose type is described in words.
ParamInfo option_info(const std::string& name, const std::string& type, const std::string& doc);

/// One of several words.
ParamInfo choice_info(const std::string& name, std::vector<std::string> choices,
                      const std::string& fallback, const std::string& doc);

/// A whole number in a range.
ParamInfo whole_info(const std::string& name, double min, double max, const std::string& fallback,
                     const std::string& doc);

}  // namespace vug::loading
