// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/reader.h>

namespace vug::loading {

const DeclarationKind& variant_declaration() {
  static const ParamInfo param = [] {
    ParamInfo info;
    info.name = "PARAM";
    info.type = "value";
    info.doc = "the value of the parameter of that name";
    return info;
  }();
  static const DeclarationKind kind = {
      {"variant",
       "declaration",
       "A named set of parameter values: variant NAME { PARAM value  PARAM value }. The option "
       "--variant NAME chooses it; each value must respect the range of its param.",
       "",
       {param}},
      [](const scene::Declaration& declaration, ReadContext& context) {
        has_block(declaration, context);
        return Value();
      },
      /*target_type=*/"",
      /*several_targets=*/false,
      /*is_value=*/false};
  return kind;
}

}  // namespace vug::loading
