// SPDX-License-Identifier: Apache-2.0
// The documentation of `grammar` blocks for `vug list`.
#include <vug/loading/grammar_binding.h>
#include <vug/loading/item_clauses.h>
#include <vug/loading/network_symbols.h>
#include <vug/loading/option_info.h>

#include <fmt/format.h>

namespace vug::loading {

const KindInfo& grammar_info() {
  static const KindInfo kind = [] {
    KindInfo info{"grammar",
                  "declaration",
                  "A solid that rules generate: grammar NAME { axiom ...  SYMBOL -> + SHAPE ... }.",
                  "zawadzki2012",
                  {}};
    for (const ParamInfo& clause : clause_infos()) info.params.push_back(clause);
    info.params.push_back(option_info(
        scene::kDressOption, "network",
        fmt::format("network that is dressed: the rules of {} apply to each of its elements",
                    network_symbol_names("and"))));
    info.params.push_back(
        option_info("geology", "field",
                    "a solid with materials, e.g. host_rock(...): a morph's amount is multiplied "
                    "by 1 - hardness at its place"));
    info.params.push_back(whole_info("steps", 1, 1e9, std::to_string(kMaxProductions),
                                     "maximum number of productions"));
    info.params.push_back(
        whole_info("limit", 1, 1e9, std::to_string(kMaxSymbols), "maximum number of symbols"));
    return info;
  }();
  return kind;
}

}  // namespace vug::loading
