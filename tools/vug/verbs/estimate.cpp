// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"
#include "print.h"
#include "progress_bar.h"
#include "render_pictures.h"

#include <fmt/format.h>
#include <vug/base/memory.h>
#include <vug/base/parallel.h>
#include <vug/base/pluralize.h>
#include <vug/building/product_keys.h>
#include <vug/building/stored_drips.h>
#include <vug/farm/budget.h>
#include <vug/picture/frame_sequence.h>
#include <vug/shot/queries.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>
#include <set>

namespace vug::cli {
namespace {

using Json = nlohmann::ordered_json;

struct EstimateOptions {
  RenderOptions render;
  std::string frames;
  std::optional<int> parts;
  farm::BudgetOptions budget;
  bool json = false;
};

/// The keys of the volumes that a picture shows.
std::set<std::string> keys_of(const shot::Shot& shot) {
  std::set<std::string> out;
  for (const shot::MeshPtr& mesh : shot::shown_meshes(shot))
    if (mesh->volume && !mesh->volume->source_mesh)
      out.insert(building::level_set_key(*mesh->volume).digest().hex());
  return out;
}

/// Whether the first, the middle and the last frame show the same volumes.
bool frames_share_products(const EstimateOptions& options, const loading::SceneSource& source,
                           const std::vector<int>& frames) {
  std::set<std::set<std::string>> different;
  for (const size_t i : {size_t{0}, frames.size() / 2, frames.size() - 1})
    different.insert(
        keys_of(*plan_pictures(options.render, options.render.scene.load(source, frames[i]).shot)
                     .front()
                     .plan.shown));
  return different.size() == 1;
}

Json estimate_report(const farm::JobOptions& job, const farm::Budget& budget, bool shared) {
  const auto rounded = [](double value) { return std::round(value); };
  Json out{{"pictures", budget.pictures},
           {"samples of a pixel", job.spp},
           {"active voxels", rounded(job.cost.voxels)},
           {"triangles", rounded(job.cost.triangles)},
           {"memory", rounded(budget.task_bytes)},
           {"products", shared ? "the same in all frames" : "others in each frame"},
           {"core seconds of a picture",
            {{"products", rounded(job.cost.build_seconds)},
             {"learning", rounded(job.cost.learn_seconds)},
             {"rendering", rounded(job.cost.render_seconds)}}},
           {"disk",
            {{"grids", rounded(budget.grid_bytes)},
             {"meshes", rounded(budget.mesh_bytes)},
             {"pictures", rounded(budget.picture_bytes)}}},
           {"tasks of a farm", budget.tasks}};
  for (const farm::Place& place : budget.places)
    out["places"].push_back({{"name", place.name},
                             {"machines", place.machines},
                             {"hours", place.hours},
                             {"core hours", place.core_hours},
                             {"money", place.money}});
  return out;
}

void print_shot_estimate(const farm::JobOptions& job, const farm::Budget& budget, bool shared,
                         int cores) {
  fmt::print("{}, {} a pixel\n", pluralize(budget.pictures, "picture"),
             pluralize(job.spp, "sample"));
  fmt::print("  {:<16}{:.3g} million active, {:.3g} million triangles\n", "voxels",
             job.cost.voxels / 1e6, job.cost.triangles / 1e6);
  fmt::print("  {:<16}{} for each task\n", "memory", bytes_text(budget.task_bytes));
  fmt::print("  {:<16}grids {}, meshes {}, pictures {}\n", "disk", bytes_text(budget.grid_bytes),
             bytes_text(budget.mesh_bytes), bytes_text(budget.picture_bytes));
  fmt::print("  {:<16}products {:.0f} s, learning {:.0f} s, rendering {:.0f} s{}\n", "core seconds",
             job.cost.build_seconds, job.cost.learn_seconds, job.cost.render_seconds,
             budget.pictures == 1 ? ""
             : shared             ? "; the products are the same in all frames"
                                  : "; each frame has products of its own");
  fmt::print("\n  {:<14}{:>18}{:>10}{:>12}{:>10}\n", "place", "machines x cores", "hours",
             "core-hours", "money");
  for (const farm::Place& place : budget.places)
    fmt::print("  {:<14}{:>18}{:>10.2f}{:>12.2f}{:>10.2f}\n", place.name,
               fmt::format("{} x {}", place.machines, cores), place.hours, place.core_hours,
               place.money);
}

int run_estimate(EstimateOptions& options) {
  RenderOptions& render = options.render;
  render.picture = picture_options(render);
  const loading::SceneSource source = render.scene.source();
  render.picture.source = &source;
  render.output = "picture.exr";
  farm::JobOptions job;
  if (!options.frames.empty()) job.frames = picture::parse_frames(options.frames);
  const loading::Loaded loaded = render.scene.load(
      source, job.frames.empty() ? render.scene.frame.value_or(1) : job.frames.front());
  const picture::PicturePlan plan = plan_pictures(render, loaded.shot).front().plan;
  job.spp = static_cast<uint32_t>(plan.render.settings.spp);
  Progress& progress = terminal_progress(render.work.bar_mode());
  // Drips that are in the store are not grown for the estimate, and others are stored.
  const auto drips = building::store_drips(loaded.shot, render.work.build_options(loaded).stored);
  // Seconds of one core, so that the report does not depend on this machine's number of cores.
  job.cost = farm::estimate_picture(plan, 1, {}, progress);
  clear_progress_bar();
  const bool shared = job.frames.empty() || frames_share_products(options, source, job.frames);
  farm::JobOptions on_machine = job;
  for (double* seconds : {&on_machine.cost.build_seconds, &on_machine.cost.learn_seconds,
                          &on_machine.cost.render_seconds})
    *seconds /= options.budget.cores;
  on_machine.parts =
      options.parts ? *options.parts : farm::default_parts(on_machine, options.budget.machines);
  const farm::Budget budget = farm::budget(on_machine, shared, options.budget);
  if (options.json)
    print_report(estimate_report(job, budget, shared), true);
  else
    print_shot_estimate(job, budget, shared, options.budget.cores);
  return kDone;
}

void add_prices(CLI::App& app, farm::BudgetOptions& budget) {
  const auto add = [&](const char* name, double& value, const char* doc) {
    app.add_option(name, value, doc)
        ->check(number_in(Dimension::none, 0, 1e6))
        ->capture_default_str()
        ->group("Prices");
  };
  add("--core-price", budget.prices.core_hour, "Price of a core for an hour");
  add("--spot-price", budget.prices.spot_core_hour, "The same on spot nodes");
  add("--storage-price", budget.prices.gigabyte_month, "Price of a gigabyte for a month");
  add("--transfer-price", budget.prices.gigabyte_out,
      "Price of a gigabyte of pictures that leaves the provider");
  add("--months", budget.months, "How long the files are stored");
  add("--losses", budget.spot.losses_per_hour, "Expected losses of a spot node per hour");
  add("--start", budget.spot.start_seconds, "Seconds from the request of a node to its task");
}

}  // namespace

Verb estimate_verb() {
  return {"estimate",
          "Prints what the pictures of a scene will take before anything is built: voxels, "
          "triangles, memory, disk, core-hours and money, on one machine, a farm, and spot nodes.",
          [](CLI::App& app) {
            auto options = std::make_shared<EstimateOptions>();
            options->budget.cores = thread_count();
            add_picture_options(app, options->render);
            app.add_option("--frames", options->frames, "Frames of a sequence, A..B or A..BxSTEP")
                ->excludes("--frame");
            app.add_option("--cores", options->budget.cores,
                           "Cores of each machine; default: those of this machine")
                ->check(integer_in(1, 1024));
            app.add_option("--machines", options->budget.machines, "Machines of the farm")
                ->check(integer_in(1, 100000))
                ->capture_default_str();
            app.add_option("--parts", options->parts,
                           "Tasks for each picture; default by its samples and --machines")
                ->check(integer_in(1, 10000));
            add_prices(app, options->budget);
            app.add_flag("--json", options->json, "The report as JSON, in bytes and seconds");
            options->render.work.add_to(app);
            return [options] {
              return with_threads(options->render.work.threads,
                                  [&] { return run_estimate(*options); });
            };
          }};
}

}  // namespace vug::cli
