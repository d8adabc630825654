// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/kind_params.h>

namespace vug::loading {

const ParamInfo* find_param(const KindInfo& kind, size_t position, const std::string& name) {
  if (name.empty()) return position < kind.params.size() ? &kind.params[position] : nullptr;
  for (const ParamInfo& param : kind.params)
    if (param.name == name) return &param;
  return nullptr;
}

std::string_view element_type(std::string_view type) {
  constexpr std::string_view kList = "list of ";
  if (type.starts_with(kList)) type.remove_prefix(kList.size());
  return type;
}

}  // namespace vug::loading
