#include <vug/facade/element.h>

namespace vug::facade {

std::string element_text(const KindInfo& kind, const Arguments& arguments) {
  Diagnostics none;
  const std::vector<int> places = detail::match_arguments(kind, arguments, {}, none);
  std::string told;
  for (size_t i = 0; i < arguments.size(); ++i) {
    const ParamInfo& param = kind.params.at(static_cast<size_t>(places[i]));
    told += (told.empty() ? "" : ", ") + param.name + ": " +
            detail::default_text(arguments[i].value, param.dimension);
  }
  return told.empty() ? kind.name : kind.name + "(" + told + ")";
}

}  // namespace vug::facade
