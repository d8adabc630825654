// SPDX-License-Identifier: Apache-2.0
// A single instance with rotation and scale.
#include <vug/loading/instance_source_kinds.h>

namespace vug::loading {
namespace {

struct Pose {
  Vec3d position{0, 0, 0};
  double yaw = 0, pitch = 0, roll = 0;
  double scale = 1;
  Vec3d stretch{1, 1, 1};
  std::optional<int> model;

  static void describe(Schema<Pose>& s) {
    const auto angle = [](std::string doc) {
      return ParamSpec{.doc = std::move(doc), .dimension = Dimension::angle};
    };
    s.doc("One instance: the model is scaled, rotated about its own origin, then moved.")
        .param("position", &Pose::position, any_length("position of its origin"))
        .param("yaw", &Pose::yaw,
               angle("rotation about the vertical, from z towards x; applied last"))
        .param("pitch", &Pose::pitch, angle("rotation about x; applied second"))
        .param("roll", &Pose::roll, angle("rotation about z; applied first"))
        .param("scale", &Pose::scale, {.doc = "factor of the size", .min = 0, .above_min = true})
        .param("stretch", &Pose::stretch,
               {.doc = "factors of the size along its own axes; negative: mirrored"})
        .param("model", &Pose::model,
               {.doc = "index of the model, counted from 0; default: random", .min = 0});
  }
  std::string fault() const {
    return stretch.x == 0 || stretch.y == 0 || stretch.z == 0
               ? "a model scaled by 0 is flat and cannot be placed"
               : "";
  }
};

}  // namespace
}  // namespace vug::loading

VUG_INSTANCE_SOURCE_KIND(pose) {
  return make_kind<shot::InstanceSource, Pose>(
      "pose", "places", [](const Pose& p) -> shot::InstanceSource {
        const int model = p.model.value_or(-1);
        const Transform at =
            building::pose_transform(p.position, p.yaw, p.pitch, p.roll, p.stretch * p.scale);
        const auto make = [at, model](building::Builder&, RandomKey key) {
          return std::vector<building::Instance>{{at, key, model}};
        };
        return std::make_shared<const building::InstanceFunction>(
            building::IndexedInstanceSource{.make = make, .last_model = model, .is_given = true});
      });
}
