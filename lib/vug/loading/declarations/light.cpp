// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/reader.h>

namespace vug::loading {

const DeclarationKind& light_declaration() {
  static const DeclarationKind kind = {
      kind_declaration_info("light", "A light or a sky: light NAME = rect(...).", "light", ""),
      [](const scene::Declaration& declaration, ReadContext& context) {
        const Value value = read_kind_declaration("light", "", declaration, context);
        if (const auto* light = value.object<render::LightPtr>())
          context.shot.lights.emplace_back(declaration.name, *light);
        return value;
      }};
  return kind;
}

}  // namespace vug::loading
