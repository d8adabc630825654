#include "bar.h"
#include "load.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/session/inputs.h>
#include <vug/session/write.h>

namespace vug::cli {
namespace {

struct Options {
  SceneOptions scene;
  WorkOptions work;
  std::string folder;
};

int run(const Options& options) {
  const session::Loaded loaded = options.scene.load();
  require_outputs(session::product_paths(loaded.shot, options.folder),
                  session::files_named(loaded));
  const ThreadLimit threads(options.work.threads);
  session::Builder builder(loaded.shot, options.work.build_options(loaded),
                           terminal_progress(options.work.bar()));
  const auto paths = session::write_products(builder, options.folder);
  if (paths.empty())
    throw Error(ErrorCode::bad_input,
                fmt::format("'{}' declares nothing to build", options.scene.scene), {},
                "add for instance: volume rock = level_set(..., voxel: 5cm)");
  for (const auto& path : paths) fmt::print("{}\n", path.string());
  options.work.summarise(builder);
  return kDone;
}

}  // namespace

Verb build_verb() {
  return {"build", "Makes everything a scene declares: .vdb, meshes.", [](CLI::App& app) {
            auto options = std::make_shared<Options>();
            options->scene.add_to(app);
            app.add_option("-o,--output", options->folder, "the folder to write into")->required();
            options->work.add_to(app);
            return [options] { return run(*options); };
          }};
}

}  // namespace vug::cli
