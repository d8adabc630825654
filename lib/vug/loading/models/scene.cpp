// SPDX-License-Identifier: Apache-2.0
// A whole scene as a model that another scene can place.
#include <vug/loading/instance_source_kinds.h>

namespace vug::loading {
namespace {

struct SceneModel {
  std::filesystem::path file;
  std::optional<int> seed;
  std::vector<std::string> with;

  static void describe(Schema<SceneModel>& s) {
    s.doc(
         "Another scene: its objects with their materials, and its lights, without its skies, "
         "media, cameras "
         "and render blocks.")
        .param("file", &SceneModel::file, {.doc = "the .vug file", .required = true})
        .param("seed", &SceneModel::seed, {.doc = "instead of its own", .min = 0})
        .param("with", &SceneModel::with,
               {.doc = "values of its parameters, as for -D: \"voxel=5cm\""});
  }
};

}  // namespace

const Kind<shot::Model>& scene_model() {
  static const Kind<shot::Model> kind =
      make_kind<shot::Model, SceneModel>("scene", "model", [](const SceneModel& s) {
        shot::Model model;
        model.name = s.file.stem().string();
        model.file = s.file;
        model.seed = s.seed;
        model.with = s.with;
        return model;
      });
  return kind;
}

}  // namespace vug::loading
