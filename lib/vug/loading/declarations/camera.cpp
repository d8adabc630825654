#include <vug/loading/reader.h>

namespace vug::loading {

const DeclarationKind& camera_declaration() {
  static const DeclarationKind kind = {
      family_info("camera", "Where the picture is taken from: camera NAME { eye ... }.", "camera",
                  "perspective"),
      [](const scene::Declaration& declaration, Reading& reading) {
        const Value value = read_family("camera", "perspective", declaration, reading);
        if (const auto* camera = value.object<render::CameraPtr>())
          reading.shot.cameras.push_back({declaration.name, *camera, declaration.where});
        return value;
      }};
  return kind;
}

}  // namespace vug::loading
