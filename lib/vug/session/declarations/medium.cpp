#include <vug/session/reader.h>

namespace vug::session {

const DeclarationKind& medium_declaration() {
  static const DeclarationKind kind = {
      family_info("medium", "What fills the air: medium NAME = haze(...).", "medium", ""),
      [](const scene::Declaration& declaration, Reading& reading) {
        const Value value = read_family("medium", "", declaration, reading);
        if (const auto* medium = value.object<render::MediumPtr>()) {
          if (reading.shot.medium)
            reading.diagnostics.error(declaration.where, "a scene has one medium at most");
          reading.shot.medium = *medium;
        }
        return value;
      }};
  return kind;
}

}  // namespace vug::session
