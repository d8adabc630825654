#include <vug/loading/reader.h>

namespace vug::loading {

const DeclarationKind& material_declaration() {
  static const DeclarationKind kind = {
      family_info("material", "What a surface is made of: material NAME = lambert(...).",
                  "material", "lambert"),
      [](const scene::Declaration& declaration, Reading& reading) {
        const Value value = read_family("material", "lambert", declaration, reading);
        if (const auto* material = value.object<render::MaterialPtr>())
          reading.shot.materials.emplace_back(declaration.name, *material);
        return value;
      }};
  return kind;
}

}  // namespace vug::loading
