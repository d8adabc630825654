// SPDX-License-Identifier: Apache-2.0
// Queries: values of the facade bench as text, for the `expect` lines of scripts.
#pragma once

#include <vug/base/kind.h>

#include <string>
#include <vector>

namespace vug::workbench {

class FacadeBench;

struct Query {
  std::string name;
  std::string doc;             ///< One sentence.
  std::string arguments = {};  ///< Syntax: "ACTION".
  size_t words = 0;            ///< Number of arguments.
  std::string (*answer)(const FacadeBench&, const std::vector<std::string>& words) = nullptr;
};

/// Generated from the list in CMakeLists.txt.
const std::vector<const Query*>& queries();

/// Evaluates an assertion: "NAME [ARGUMENTS] = TEXT", or "contains TEXT", "above NUMBER", "below
/// NUMBER". Error(bad_input) with the actual value if it does not hold.
void expect(const FacadeBench& bench, const std::vector<std::string>& words);

/// Compares an actual value; `name` is for the message.
void expect_value(const std::string& name, const std::string& actual, const std::string& relation,
                  const std::string& value);

}  // namespace vug::workbench

/// Opens the one definition that the file of a query exports; see VUG_EXPORT_KIND.
#define VUG_QUERY(name) VUG_EXPORT_KIND(vug::workbench, Query, name##_query)
