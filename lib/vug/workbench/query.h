// SPDX-License-Identifier: Apache-2.0
// Queries: values of a bench as text, for the `expect` lines of scripts.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/base/kind.h>

#include <cstddef>
#include <string>
#include <vector>

namespace vug::workbench {

class FacadeBench;

/// A query of a bench: of facades (FacadeBench) or of scenes (SceneBench).
template <class Bench>
struct QueryOf {
  std::string name;
  std::string doc;             ///< One sentence.
  std::string arguments = {};  ///< Syntax: "ACTION".
  size_t words = 0;            ///< Number of arguments.
  std::string (*answer)(const Bench&, const std::vector<std::string>& words) = nullptr;
};
using Query = QueryOf<FacadeBench>;

/// Generated from the list in CMakeLists.txt.
const std::vector<const Query*>& queries();

/// Evaluates an assertion: "NAME [ARGUMENTS] = TEXT", or "contains TEXT", "above NUMBER", "below
/// NUMBER". Error(bad_input) with the actual value if it does not hold.
void expect(const FacadeBench& bench, const std::vector<std::string>& words);

/// Compares an actual value; `name` is for the message.
void expect_value(const std::string& name, const std::string& actual, const std::string& relation,
                  const std::string& value);

/// Evaluates an assertion with one of these queries; see `expect`.
template <class Bench>
void expect_in(const std::vector<const QueryOf<Bench>*>& all, const Bench& bench,
               const std::vector<std::string>& words) {
  if (words.empty())
    throw Error(ErrorCode::bad_input, "nothing is expected", {}, "such as: expect dirty = no");
  std::vector<std::string> names;
  for (const QueryOf<Bench>* query : all) {
    names.push_back(query->name);
    if (query->name != words[0]) continue;
    if (words.size() != query->words + 3)
      throw Error(ErrorCode::bad_input, "wrong number of words after '" + query->name + "'", {},
                  "expect " + query->name + " " + query->arguments + " = TEXT");
    const auto relation = words.begin() + 1 + static_cast<std::ptrdiff_t>(query->words);
    const std::vector<std::string> arguments(words.begin() + 1, relation);
    return expect_value(query->name, query->answer(bench, arguments), relation[0], relation[1]);
  }
  throw Error(ErrorCode::bad_input, "unknown query '" + words[0] + "'", {},
              suggestion(words[0], names));
}

}  // namespace vug::workbench

/// Opens the one definition that the file of a query exports; see VUG_EXPORT_KIND.
#define VUG_QUERY(name) VUG_EXPORT_KIND(vug::workbench, Query, name##_query)
