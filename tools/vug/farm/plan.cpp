// SPDX-License-Identifier: Apache-2.0
// `vug farm plan`: divides the pictures of a scene into tasks.
#include "arguments.h"
#include "process.h"
#include "progress_bar.h"
#include "render_pictures.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/hash.h>
#include <vug/base/memory.h>
#include <vug/base/parallel.h>
#include <vug/base/pluralize.h>
#include <vug/building/stored_drips.h>
#include <vug/farm/engine_files.h>
#include <vug/farm/plan_job.h>
#include <vug/loading/dependencies.h>
#include <vug/picture/frame_sequence.h>

#include <memory>
#include <set>

namespace vug::cli {
namespace {

namespace fs = std::filesystem;

struct PlanOptions {
  RenderOptions render;
  std::string frames, folder, program;
  std::optional<int> parts, chunk;
  int cores = 1, for_cores = 0;
};

/// The options of the command line that the tasks repeat: all but those of the plan itself.
std::vector<std::string> repeated_arguments(const CLI::App& app) {
  const std::set<std::string> own{"--frames", "--output",    "--parts",   "--chunk",
                                  "--cores",  "--for-cores", "--program", "--threads",
                                  "--quiet",  "--progress",  "--help"};
  std::vector<std::string> out{"--quiet"};
  for (const CLI::Option* option : app.get_options()) {
    if (option->count() == 0 || option->get_positional()) continue;
    const std::string name = option->get_lnames().empty() ? "-" + option->get_snames().front()
                                                          : "--" + option->get_lnames().front();
    if (own.count(name)) continue;
    if (option->get_items_expected_max() == 0) {  // a flag
      out.push_back(name);
      continue;
    }
    for (const std::string& value : option->results()) out.insert(out.end(), {name, value});
  }
  return out;
}

std::vector<farm::Input> inputs_of(const loading::Loaded& loaded) {
  std::vector<farm::Input> out;
  for (const fs::path& file : loading::file_dependencies(loaded))
    out.push_back({fs::absolute(file).lexically_normal().string(), digest(read_text(file)).hex()});
  return out;
}

/// Error(bad_input) for settings that only work for whole pictures or sequences.
void require_divisible(const picture::PicturePlan& plan, const farm::JobOptions& job) {
  const shot::RenderSettings& settings = plan.render.settings;
  if (job.parts > 1 && settings.noise > 0)
    throw Error(ErrorCode::bad_input,
                "the parts of a picture cannot use 'noise': the number of samples is decided for "
                "the whole picture",
                plan.render.where, "write --noise 0, or --parts 1 to divide only frames");
  if (picture::is_stereo(plan) && plan.options.eye == 0)
    throw Error(ErrorCode::bad_input, "a job contains one view of a stereo camera",
                plan.render.where, "plan one job for each: --eye left");
  if (settings.exposure.mode == shot::Exposure::Mode::locked && job.frames.size() > 1)
    throw Error(ErrorCode::bad_input,
                "the exposure 'locked' needs the first frame, but tasks render frames in any order",
                plan.render.where,
                "render the first frame, and write the exposure that `vug info` prints: "
                "--exposure 2.5");
}

void print_summary(const farm::Job& job, const PlanOptions& options, size_t chunk,
                   const std::vector<farm::EngineFile>& files) {
  double seconds = 0, bytes = 0;
  for (const farm::Task& task : job.tasks)
    seconds += task.seconds, bytes = std::max(bytes, task.bytes);
  fmt::print("{} in {}, about {:.1f} h on {} and {} for each\n",
             pluralize(job.pictures.size(), "picture"), pluralize(job.tasks.size(), "task"),
             seconds / 3600, pluralize(static_cast<size_t>(options.cores), "core"),
             bytes_text(bytes));
  if (chunk > 1)
    fmt::print("{} of a picture share a process (--chunk)\n", pluralize(chunk, "part"));
  fmt::print("start it with one of these, in {}:\n  vug farm run .\n", options.folder);
  for (const farm::EngineFile& file : files) fmt::print("  {}\n", file.command);
}

int run_plan(PlanOptions& options, const std::vector<std::string>& arguments) {
  const fs::path folder = options.folder;
  if (fs::exists(folder / farm::kJobFile))
    throw Error(ErrorCode::bad_input, fmt::format("'{}' already contains a job", options.folder),
                {},
                "continue it with: vug farm run " + options.folder + "; or choose another folder");
  RenderOptions& render = options.render;
  render.picture = picture_options(render);
  Progress& progress = terminal_progress(render.work.bar_mode());
  const loading::SceneSource source = render.scene.source();
  render.picture.source = &source;
  farm::JobOptions job;
  if (!options.frames.empty()) job.frames = picture::parse_frames(options.frames);
  const loading::Loaded loaded = render.scene.load(
      source, job.frames.empty() ? render.scene.frame.value_or(1) : job.frames.front());
  render.output = "picture.exr";
  const std::vector<PlannedPicture> pictures = plan_pictures(render, loaded.shot);
  if (pictures.size() != 1)
    throw Error(ErrorCode::bad_input, "a job contains the pictures of one render block", {},
                "plan one job for each: --render NAME");
  const picture::PicturePlan& plan = pictures.front().plan;
  job.scene = fs::absolute(render.scene.scene).lexically_normal().string();
  job.name = fs::path(render.scene.scene).stem().string();
  job.render_arguments = arguments;
  job.spp = static_cast<uint32_t>(plan.render.settings.spp);
  // Drips that are in the store are not grown for the estimate, and others are stored.
  const building::StoreUse stored = render.work.build_options(loaded).stored;
  const auto drips = building::store_drips(loaded.shot, stored);
  job.cost = farm::estimate_picture(plan, options.cores, {}, progress, stored);
  const int machines = options.for_cores > 0 ? options.for_cores : 8 * options.cores;
  job.parts = options.parts ? *options.parts
              : plan.render.settings.noise > 0
                  ? 1
                  : farm::default_parts(job, std::max(1, machines / options.cores));
  job.inputs = inputs_of(loaded);
  require_divisible(plan, job);
  const farm::Job planned = farm::plan_job(job);
  const auto chunk = static_cast<size_t>(options.chunk.value_or(farm::default_chunk(job)));
  const std::vector<farm::EngineFile> files =
      farm::engine_files(planned, {options.program, options.cores, chunk});
  for (const farm::EngineFile& file : files) {
    write_text(folder / file.name, file.text);
    if (file.executable)
      fs::permissions(folder / file.name, fs::perms::owner_exec | fs::perms::group_exec,
                      fs::perm_options::add);
  }
  write_text(folder / farm::kJobFile, farm::to_json(planned));
  clear_progress_bar();
  print_summary(planned, options, chunk, files);
  return kDone;
}

}  // namespace

Verb farm_plan_verb() {
  return {"plan",
          "Writes a folder with a job: the tasks that make the pictures of a scene, and files for "
          "ninja, GNU parallel, Slurm and OpenJD.",
          [](CLI::App& app) {
            auto options = std::make_shared<PlanOptions>();
            options->program = current_executable().string();
            options->cores = thread_count();
            add_picture_options(app, options->render);
            app.add_option("-o,--output", options->folder, "Folder of the job")->required();
            app.add_option("--frames", options->frames, "Frames of a sequence, A..B or A..BxSTEP")
                ->excludes("--frame");
            app.add_option("--parts", options->parts,
                           "Tasks for each picture; default by its samples and --for-cores")
                ->check(integer_in(1, 10000));
            app.add_option("--chunk", options->chunk,
                           "Parts of one picture that run in one process, which loads the scene "
                           "once; default so that loading takes at most 5 % of its time")
                ->check(integer_in(1, 10000));
            app.add_option("--cores", options->cores,
                           "Cores of each task; default all of this "
                           "machine")
                ->check(integer_in(1, 1024));
            app.add_option("--for-cores", options->for_cores,
                           "Cores of all machines together; default eight times --cores")
                ->check(integer_in(1, 1000000));
            app.add_option("--program", options->program,
                           "The program as the machines of the farm find it; default this one");
            options->render.work.add_to(app);
            return [&app, options] { return run_plan(*options, repeated_arguments(app)); };
          }};
}

}  // namespace vug::cli
