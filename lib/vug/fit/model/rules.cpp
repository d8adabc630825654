// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/model/rules.h>

namespace vug::fit {

Rules with_index(Rules rules) {
  rules.by_head.assign(rules.symbols.size(), {});
  for (size_t i = 0; i < rules.productions.size(); ++i)
    rules.by_head[static_cast<size_t>(rules.productions[i].head)].push_back(static_cast<int>(i));
  return rules;
}

}  // namespace vug::fit
