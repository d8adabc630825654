// SPDX-License-Identifier: Apache-2.0
// Lookup of a kind by a name that a user typed.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/base/error.h>

#include <string>
#include <vector>

namespace vug {

/// The element whose `info.name` equals `name`. Throws Error(bad_input) with the message `refusal`
/// and the nearest known name as the hint if there is no such element.
template <class Thing>
const Thing& require_kind(const std::vector<const Thing*>& all, const std::string& name,
                          const std::string& refusal) {
  std::vector<std::string> known;
  for (const Thing* each : all) {
    if (each->info.name == name) return *each;
    known.push_back(each->info.name);
  }
  throw Error(ErrorCode::bad_input, refusal, {}, suggestion(name, known));
}

}  // namespace vug
