#include <vug/field/kind.h>
#include <vug/loading/reader.h>

namespace vug::loading {

const DeclarationKind& field_declaration() {
  static const DeclarationKind kind = {
      family_info("field", "Names a solid: field NAME = EXPRESSION.", "field", ""),
      [](const scene::Declaration& declaration, Reading& reading) {
        return read_family("field", "", declaration, reading);
      }};
  return kind;
}

}  // namespace vug::loading
