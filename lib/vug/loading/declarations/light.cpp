#include <vug/loading/reader.h>

namespace vug::loading {

const DeclarationKind& light_declaration() {
  static const DeclarationKind kind = {
      family_info("light", "A lamp or a sky: light NAME = rect(...).", "light", ""),
      [](const scene::Declaration& declaration, Reading& reading) {
        const Value value = read_family("light", "", declaration, reading);
        if (const auto* light = value.object<render::LightPtr>())
          reading.shot.lights.emplace_back(declaration.name, *light);
        return value;
      }};
  return kind;
}

}  // namespace vug::loading
