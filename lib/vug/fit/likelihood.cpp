// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/fit/likelihood.h>

#include <fmt/format.h>

namespace vug::fit {

LikelihoodPtr make_likelihood(const std::string& name, const Evidence& evidence) {
  std::vector<std::string> known;
  for (const LikelihoodKind* kind : likelihood_kinds()) {
    if (kind->info.name == name) return kind->make(evidence);
    known.push_back(kind->info.name);
  }
  throw Error(ErrorCode::bad_input, fmt::format("unknown likelihood '{}'", name), {},
              suggestion(name, known));
}

}  // namespace vug::fit
