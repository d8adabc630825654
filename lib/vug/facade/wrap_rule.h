// SPDX-License-Identifier: Apache-2.0
// Line breaks in the text of a rule.
#pragma once

#include <string>

namespace vug::facade {

/// The rule, indented by two columns, in lines of at most `columns` columns, broken after commas in
/// brackets with the indents of `vug format`. A longer line has no such comma.
std::string wrap_rule(const std::string& rule, size_t columns = 100);

}  // namespace vug::facade
