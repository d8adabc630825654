#include "load.h"

#include <fmt/format.h>

namespace vug::cli {

Verb check_verb() {
  return {"check", "Finds every fault of a scene without computing it.", [](CLI::App& app) {
            auto options = std::make_shared<SceneOptions>();
            auto quiet = std::make_shared<bool>(false);
            options->add_to(app);
            app.add_flag("--quiet,-q", *quiet, "say nothing when all is well");
            return [options, quiet] {
              const session::Loaded loaded = options->load();
              const session::Shot& shot = loaded.shot;
              if (!*quiet)
                fmt::print("{}: fine; {} volumes, {} meshes, {} objects, {} lights, {} cameras\n",
                           options->scene, shot.volumes.size(), shot.meshes.size(),
                           shot.objects.size(), shot.lights.size(), shot.cameras.size());
              return kDone;
            };
          }};
}

}  // namespace vug::cli
