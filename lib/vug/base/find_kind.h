// One of a list of kinds by its name, for what users have typed.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/base/error.h>

#include <string>
#include <vector>

namespace vug {

/// Of pointers to things with an `info.name` the one of that name. Error(bad_input) with `refusal`
/// and the nearest of the names where there is none.
template <class Thing>
const Thing& named_kind(const std::vector<const Thing*>& all, const std::string& name,
                        const std::string& refusal) {
  std::vector<std::string> known;
  for (const Thing* each : all) {
    if (each->info.name == name) return *each;
    known.push_back(each->info.name);
  }
  throw Error(ErrorCode::bad_input, refusal, {}, suggestion(name, known));
}

}  // namespace vug
