// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/reader.h>

namespace vug::loading {

const DeclarationKind& material_declaration() {
  static const DeclarationKind kind = {
      kind_declaration_info("material", "The material of a surface: material NAME = lambert(...).",
                            "material", "lambert"),
      [](const scene::Declaration& declaration, ReadContext& context) {
        const Value value = read_kind_declaration("material", "lambert", declaration, context);
        if (const auto* material = value.object<render::MaterialPtr>())
          context.shot.materials.emplace_back(declaration.name, *material);
        return value;
      }};
  return kind;
}

}  // namespace vug::loading
