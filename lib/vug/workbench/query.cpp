// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/base/error.h>
#include <vug/workbench/query.h>
#include <vug/workbench/words.h>

#include <fmt/format.h>

namespace vug::workbench {
namespace {

const Query& find_query(const std::string& name) {
  std::vector<std::string> names;
  for (const Query* each : queries()) {
    if (each->name == name) return *each;
    names.push_back(each->name);
  }
  throw Error(ErrorCode::bad_input, fmt::format("unknown query '{}'", name), {},
              suggestion(name, names));
}

}  // namespace

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
  if (words.empty())
    throw Error(ErrorCode::bad_input, "nothing is expected", {}, "such as: expect edits = 4");
  const Query& query = find_query(words[0]);
  if (words.size() != query.words + 3)
    throw Error(ErrorCode::bad_input, fmt::format("wrong number of words after '{}'", query.name),
                {}, fmt::format("expect {} {} = TEXT", query.name, query.arguments));
  const std::vector<std::string> arguments(words.begin() + 1,
                                           words.begin() + 1 + static_cast<long>(query.words));
  expect_value(query.name, query.answer(bench, arguments), words[query.words + 1],
               words[query.words + 2]);
}

}  // namespace vug::workbench
