#include <vug/session/reader.h>

namespace vug::session {

const DeclarationKind& material_declaration() {
  static const DeclarationKind kind = {
      family_info("material", "What a surface is made of: material NAME = lambert(...).",
                  "material", "lambert"),
      [](const scene::Declaration& declaration, Reading& reading) {
        return read_family("material", "lambert", declaration, reading);
      }};
  return kind;
}

}  // namespace vug::session
