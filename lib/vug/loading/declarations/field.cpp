// SPDX-License-Identifier: Apache-2.0
#include <vug/field/kind.h>
#include <vug/loading/reader.h>

namespace vug::loading {

const DeclarationKind& field_declaration() {
  static const DeclarationKind kind = {
      kind_declaration_info("field", "Names a solid: field NAME = EXPRESSION.", "field", ""),
      [](const scene::Declaration& declaration, ReadContext& context) {
        return read_kind_declaration("field", "", declaration, context);
      }};
  return kind;
}

}  // namespace vug::loading
