// A whole scene as a thing to place in another one.
#include <vug/session/place_kinds.h>

namespace vug::session {
namespace {

struct SceneModel {
  std::filesystem::path file;
  std::optional<int> seed;
  std::vector<std::string> with;

  static void describe(Schema<SceneModel>& s) {
    s.doc(
         "Another scene: its objects with their materials, and its lamps. Its skies, air, cameras "
         "and render blocks stay behind.")
        .param("file", &SceneModel::file, {.doc = "the .vug file", .required = true})
        .param("seed", &SceneModel::seed, {.doc = "instead of its own", .min = 0})
        .param("with", &SceneModel::with,
               {.doc = "values of its parameters, as -D takes them: \"voxel=5cm\""});
  }
};

}  // namespace

const Kind<Model>& scene_model() {
  static const Kind<Model> kind =
      make_kind<Model, SceneModel>("scene", "model", [](const SceneModel& s) {
        Model model;
        model.name = s.file.stem().string();
        model.file = s.file;
        model.seed = s.seed;
        model.with = s.with;
        return model;
      });
  return kind;
}

}  // namespace vug::session
