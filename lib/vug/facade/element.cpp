// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/element.h>

namespace vug::facade {

std::string element_text(const KindInfo& kind, const Arguments& arguments) {
  Diagnostics none;
  const std::vector<int> places = detail::match_arguments(kind, arguments, {}, none);
  std::string arguments_text;
  for (size_t i = 0; i < arguments.size(); ++i) {
    const ParamInfo& param = kind.params.at(static_cast<size_t>(places[i]));
    arguments_text += (arguments_text.empty() ? "" : ", ") + param.name + ": " +
                      detail::default_text(arguments[i].value, param.dimension);
  }
  return arguments_text.empty() ? kind.name : kind.name + "(" + arguments_text + ")";
}

}  // namespace vug::facade
