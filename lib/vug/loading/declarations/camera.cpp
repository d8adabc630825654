// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/reader.h>

namespace vug::loading {

namespace {

KindInfo camera_info() {
  KindInfo info = kind_declaration_info(
      "camera", "The camera of a picture: camera NAME { eye ... }.", "camera", "perspective");
  ParamInfo scout;
  scout.name = "scout";
  scout.type = "number";
  scout.doc = "the number of a shot that 'vug scout' found, in place of all other values";
  info.params.push_back(std::move(scout));
  return info;
}

}  // namespace

const DeclarationKind& camera_declaration() {
  static const DeclarationKind kind = {
      camera_info(), [](const scene::Declaration& declaration, ReadContext& context) {
        const Value value = read_kind_declaration("camera", "perspective", declaration, context);
        if (const auto* camera = value.object<render::CameraPtr>())
          context.shot.cameras.push_back({declaration.name, *camera, declaration.where});
        return value;
      }};
  return kind;
}

}  // namespace vug::loading
