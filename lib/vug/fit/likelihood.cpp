// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/fit/likelihood.h>

#include <fmt/format.h>

namespace vug::fit {

#define VUG_KIND(name) const LikelihoodKind& name##_likelihood();
#include <vug/fit/likelihoods_kinds.inc>
#undef VUG_KIND

const std::vector<const LikelihoodKind*>& likelihood_kinds() {
#define VUG_KIND(name) &name##_likelihood(),
  static const std::vector<const LikelihoodKind*> kinds = {
#include <vug/fit/likelihoods_kinds.inc>
  };
#undef VUG_KIND
  return kinds;
}

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
