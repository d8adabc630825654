// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/reader.h>

namespace vug::loading {

const DeclarationKind& camera_declaration() {
  static const DeclarationKind kind = {
      kind_declaration_info("camera", "The camera of a picture: camera NAME { eye ... }.", "camera",
                            "perspective"),
      [](const scene::Declaration& declaration, ReadContext& context) {
        const Value value = read_kind_declaration("camera", "perspective", declaration, context);
        if (const auto* camera = value.object<render::CameraPtr>())
          context.shot.cameras.push_back({declaration.name, *camera, declaration.where});
        return value;
      }};
  return kind;
}

}  // namespace vug::loading
