// SPDX-License-Identifier: Apache-2.0
#include "scene_options.h"

#include <fmt/format.h>
#include <vug/base/pluralize.h>
#include <vug/language/check.h>
#include <nlohmann/json.hpp>

namespace vug::cli {
namespace {

struct CheckOptions {
  SceneOptions scene;
  bool quiet = false;
  bool json = false;
  bool provenance = false;
};

using Json = nlohmann::ordered_json;

Json to_json(const loading::Loaded& loaded, const std::string& file) {
  Json faults = Json::array();
  for (const Diagnostic& one : loaded.diagnostics.all())
    faults.push_back({{"severity", one.severity == Severity::error ? "error" : "warning"},
                      {"file", one.where.file},
                      {"line", one.where.line},
                      {"column", one.where.column},
                      {"end_line", one.where.end_line},
                      {"end_column", one.where.end_column},
                      {"message", one.message},
                      {"hint", one.hint}});
  return {{"file", file}, {"fine", loaded.usable()}, {"diagnostics", std::move(faults)}};
}

/// Loads the scene and checks what `vug render` with default options would check.
loading::Loaded load_and_check(const CheckOptions& options) {
  loading::Loaded loaded = loading::load(options.scene.scene, options.scene.load_options());
  if (loaded.usable()) language::check_products(loaded, options.scene.scene, {.thorough = true});
  return loaded;
}

loading::Loaded examine(const CheckOptions& options) {
  loading::Loaded loaded = load_and_check(options);
  options.scene.apply_strictness(loaded.diagnostics);
  return loaded;
}

/// Prints the faults as JSON, even if the scene file cannot be read.
int run_json(const CheckOptions& options) {
  loading::Loaded loaded;
  try {
    loaded = examine(options);
  } catch (const Error& error) {
    loaded.diagnostics.error(error.where(), error.what(), error.hint());
  }
  fmt::print(
      "{}\n",
      to_json(loaded, options.scene.scene).dump(2, ' ', false, Json::error_handler_t::replace));
  return loaded.usable() ? kDone : kUnusable;
}

/// Prints each declaration, function and rule with the range of its text.
void print_provenance(const loading::Loaded& loaded) {
  for (const auto& each : loaded.provenance.declared())
    fmt::print("{} {}: {}\n", each.kind, each.name,
               loaded.provenance.describe({each.where, nullptr}));
}

int run_check(const CheckOptions& options) {
  if (options.json) return run_json(options);
  const loading::Loaded loaded = examine(options);
  fmt::print(stderr, "{}", loaded.report());
  if (!loaded.usable()) return kUnusable;
  const shot::Shot& shot = loaded.shot;
  if (!options.quiet)
    fmt::print("{}: fine; {}, {}, {}, {}, {}, {}, {}\n", options.scene.scene,
               pluralize(shot.volumes.size(), "volume"), pluralize(shot.meshes.size(), "mesh"),
               pluralize(shot.objects.size(), "object"), pluralize(shot.instancers.size(), "place"),
               pluralize(shot.lights.size(), "light"), pluralize(shot.cameras.size(), "camera"),
               pluralize(shot.renders.size(), "render"));
  if (options.provenance) print_provenance(loaded);
  return kDone;
}

}  // namespace

Verb check_verb() {
  return {"check", "Reports all faults of a scene without building it.", [](CLI::App& app) {
            auto options = std::make_shared<CheckOptions>();
            options->scene.add_to(app);
            app.add_flag("--quiet,-q", options->quiet, "No output if the scene has no faults");
            app.add_flag("--json", options->json, "Machine-readable output");
            app.add_flag("--provenance", options->provenance,
                         "Also prints the text range of each declaration, function and rule");
            return [options] { return run_check(*options); };
          }};
}

}  // namespace vug::cli
