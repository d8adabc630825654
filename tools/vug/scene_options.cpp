// SPDX-License-Identifier: Apache-2.0
#include "scene_options.h"

#include "arguments.h"
#include "product_report.h"

#include <fmt/format.h>
#include <vug/base/memory.h>
#include <vug/base/pluralize.h>
#include <vug/loading/data_folders.h>
#include <vug/shot/quality.h>
#include <vug/shot/queries.h>
#include <vug/survey_files/format.h>

#include <cstdio>

namespace vug::cli {
namespace {

/// Name of the first stage.
constexpr const char* kLoading = "loading the scene";

std::vector<std::string> names_of(
    const std::vector<std::pair<std::string, shot::Quality>>& qualities) {
  std::vector<std::string> names;
  for (const auto& each : qualities) names.push_back(each.first);
  return names;
}

/// The loaded scene, after its diagnostics have been printed.
loading::Loaded usable(loading::Loaded loaded, const SceneOptions& options) {
  options.apply_strictness(loaded.diagnostics);
  fmt::print(stderr, "{}", loaded.report());
  if (!loaded.usable()) throw ExitRequest{kUnusable};
  return loaded;
}

}  // namespace

void SceneOptions::add_to(CLI::App& app, const WorkOptions* work) {
  work_ = work;
  app.add_option("scene", scene, "Scene, a .vug file")->required();
  app.add_option("-D", defines, "NAME=VALUE: value of a scene parameter")
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
  app.add_option("--variant", variant,
                 "Variant of the scene, which sets several parameters; -D takes precedence");
  app.add_option("--seed", seed, "Seed that replaces the scene's own")->check(seed_number());
  app.add_flag("--strict", strict, "Warnings about the scene are errors");
  if (work)
    app.add_option("--quality", quality,
                   "draft, look or final. draft: meshes are not polished, so that they take less "
                   "time and edges are blunt; pictures: see `vug list render`")
        ->check(one_of(names_of(shot::quality_names())));
  app.add_option("--frame", frame, "Frame number of an animated scene; default 1")
      ->transform(number_in(Dimension::none, -1e6, 1e6));
}

/// Error(bad_input) for a survey, in which the parser would find a fault in every line.
void SceneOptions::refuse_survey() const {
  if (!survey::find_format(scene)) return;
  throw Error(
      ErrorCode::bad_input, fmt::format("'{}' is a survey, not a scene", scene), {},
      fmt::format("'vug survey' reports it; in a scene, network NAME = survey(file: \"{}\") "
                  "uses it",
                  std::filesystem::path(scene).filename().string()));
}

loading::LoadOptions SceneOptions::load_options() const {
  refuse_survey();
  loading::LoadOptions options;
  options.variant = variant;
  options.seed = seed;
  options.frame = frame.value_or(1);
  options.draft = quality == "draft";
  options.unscouted = unscouted;
  for (const std::string& define : defines) {
    const size_t equals = define.find('=');
    if (equals == std::string::npos || equals == 0)
      throw Error(ErrorCode::bad_input, fmt::format("invalid option '-D {}'", define), {},
                  "write -D NAME=VALUE");
    const std::string name = define.substr(0, equals);
    for (const scene::Override& other : options.overrides)
      if (other.name == name)
        throw Error(ErrorCode::bad_input, fmt::format("'{}' is set twice", name), {},
                    "write -D once per parameter");
    options.overrides.push_back({name, define.substr(equals + 1)});
  }
  options.include_folders = loading::data_folders();
  if (work_ && !work_->max_memory.empty()) options.max_memory = work_->memory_limit();
  return options;
}

void SceneOptions::apply_strictness(Diagnostics& diagnostics) const {
  if (!strict) return;
  Diagnostics errors;
  for (const Diagnostic& one : diagnostics.all()) errors.error(one.where, one.message, one.hint);
  diagnostics = std::move(errors);
}

ProgressBarMode SceneOptions::bar_mode() const {
  return work_ ? work_->bar_mode() : ProgressBarMode::never;
}

loading::Loaded SceneOptions::load() const {
  return usable(
      show_stage(bar_mode(), kLoading, [&] { return loading::load(scene, load_options()); }),
      *this);
}

loading::SceneSource SceneOptions::source() const {
  return loading::SceneSource(scene, load_options());
}

loading::Loaded SceneOptions::load(const loading::SceneSource& source, double at) const {
  return usable(show_stage(bar_mode(), kLoading, [&] { return source.at(at); }), *this);
}

void WorkOptions::add_to(CLI::App& app) {
  app.add_option("--threads", threads, "Number of threads; 0 uses all cores")
      ->check(integer_in(0, 1024));
  app.add_option("--max-memory", max_memory,
                 "Memory limit, e.g. 8G; work that needs more is refused");
  auto* silent = app.add_flag("--quiet,-q", quiet,
                              "No progress bar and no summary; warnings are still printed");
  app.add_flag("--progress", progress, "Progress bar even if stderr is not a terminal")
      ->excludes(silent);
  app.add_flag("--no-cache", no_cache,
               "Build everything anew, without the store of finished products");
}

ProgressBarMode WorkOptions::bar_mode() const {
  return quiet      ? ProgressBarMode::never
         : progress ? ProgressBarMode::always
                    : ProgressBarMode::on_terminals;
}

uint64_t WorkOptions::memory_limit() const {
  return max_memory.empty() ? available_memory() / 10 * 9 : parse_bytes(max_memory);
}

building::BuildOptions WorkOptions::build_options(const loading::Loaded& loaded) const {
  building::BuildOptions options;
  options.max_memory = memory_limit();
  if (!no_cache) options.stored = store_use(loaded);
  options.on_warning = [&loaded](const Diagnostics& doubtful) {
    clear_progress_bar();
    fmt::print(stderr, "{}", loaded.report(doubtful));
  };
  options.where_of = [&loaded](const field::NodePtr& node) {
    const scene::Provenance* made = loaded.provenance.find(node);
    return made ? made->where : SourceLocation();
  };
  return options;
}

void WorkOptions::summarise(const building::Builder& builder) const {
  if (quiet) return;
  for (const shot::MeshPtr& plan : shot::declared_meshes(builder.shot())) {
    const std::vector<volume::SmallFeature> small = builder.small_features(plan);
    if (!small.empty() && plan->topology == shot::SmallTopology::clean)
      fmt::print(stderr, "mesh '{}': removed features smaller than two voxels: {}\n", plan->name,
                 describe(small));
    if (const size_t pieces = builder.components_removed(plan); pieces > 0)
      fmt::print(stderr, "mesh '{}': {} smaller than {} m removed\n", plan->name,
                 pluralize(pieces, "piece"), plan->smallest_piece);
  }
  constexpr double kWorthMentioning = 1;  // second
  if (stage_times().total_seconds() >= kWorthMentioning)
    fmt::print(stderr, "{}\n", stage_times().summary());
}

}  // namespace vug::cli
