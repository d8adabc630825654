// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/base/error.h>
#include <vug/workbench/query.h>
#include <vug/workbench/words.h>

#include <fmt/format.h>

namespace vug::workbench {
void expect_value(const std::string& name, const std::string& actual, const std::string& relation,
                  const std::string& value) {
  bool holds = false;
  if (relation == "=")
    holds = actual == value;
  else if (relation == "contains")
    holds = actual.find(value) != std::string::npos;
  else if (relation == "above")
    holds = parse_number(actual) > parse_number(value);
  else if (relation == "below")
    holds = parse_number(actual) < parse_number(value);
  else
    throw Error(ErrorCode::bad_input, fmt::format("unknown relation '{}'", relation), {},
                "one of: =, contains, above, below");
  if (!holds)
    throw Error(ErrorCode::bad_input,
                fmt::format("expected {} {} '{}', but it is '{}'", name, relation, value, actual));
}

void expect(const FacadeBench& bench, const std::vector<std::string>& words) {
  expect_in<FacadeBench>(queries(), bench, words);
}

}  // namespace vug::workbench
