// SPDX-License-Identifier: Apache-2.0
// Renders a bench scene (JSON with a binary PLY) and prints samples per second. Cycles renders the
// same scenes for comparison, see docs/performance.md.
//   bench_cave [SCENE.json OUT.exr] [--size WxH] [--spp N] [--threads N] [--seed N] [--portal]
//              [--mesh FILE.ply] [--sky R,G,B] [--no-lamps] [--lamps N] [--bounces N]
//              [--noise PART] [--guide HOW] [--roulette HOW] [--light-samples N]
//              [--light-sampler HOW]
// Without a scene it uses the reference cave, which the build generates
// (tests/bench/reference_caves), and skips if it is missing.
#include "bench_scene.h"

#include <vug/base/error.h>
#include <vug/image/io.h>
#include <vug/render/kinds.h>
#include <vug/render/render.h>

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <ctime>

int main(int argc, char** argv) {
  using namespace vug;  // NOLINT
  CLI::App app("Renders a bench scene");
  std::string file = VUG_BENCH_DATA "/cave_scene.json", out, size = "320x180", mesh_file, sky,
              guide = "auto", roulette = "worth", light_sampler = "tree";
  int light_samples = 2;
  render::Options options;
  bool portal = false, no_lamps = false;
  double haze = 0;
  int lamps = 0;
  app.add_option("scene", file);
  app.add_option("out", out, "EXR file; by default, the picture is discarded");
  app.add_option("--size", size);
  app.add_option("--spp", options.spp);
  app.add_option("--threads", options.threads);
  app.add_option("--seed", options.seed);
  app.add_option("--bounces", options.max_bounces);
  app.add_option("--noise", options.noise, "tiles below this noise get no more samples");
  app.add_option("--mesh", mesh_file);
  app.add_option("--sky", sky);
  app.add_option("--haze", haze);
  app.add_option("--lamps", lamps, "this many small spheres of 20 W in total, anywhere in the box");
  app.add_flag("--portal", portal);
  app.add_flag("!--no-openings", options.openings, "no automatic portals");
  app.add_flag("!--no-bright-edges", options.bright_edges, "no extra camera rays at bright edges");
  app.add_option("--guide", guide, "auto, on or off");
  app.add_option("--roulette", roulette, "worth, throughput or off");
  app.add_option("--light-samples", light_samples, "lights sampled at the first surface");
  app.add_option("--light-sampler", light_sampler, "tree or uniform");
  app.add_flag("--no-lamps", no_lamps);
  CLI11_PARSE(app, argc, argv);
  options.integrator =
      render::make_integrator("path", {{"max_bounces", options.max_bounces},
                                       {"guide", Value::Name{guide}},
                                       {"roulette", Value::Name{roulette}},
                                       {"light_samples", light_samples},
                                       {"light_sampler", Value::Name{light_sampler}}});
  const std::filesystem::path mesh = mesh_file.empty()
                                         ? std::filesystem::path(file).parent_path() / "cave.ply"
                                         : std::filesystem::path(mesh_file);
  if (out.empty() && !(std::filesystem::exists(file) && std::filesystem::exists(mesh))) {
    fmt::print("skipped: the bench needs '{}' and '{}'\n", file, mesh.string());
    return 0;
  }
  try {
    std::sscanf(size.c_str(), "%dx%d", &options.width, &options.height);
    render::Scene scene = bench::read_scene(file, mesh_file, sky, !no_lamps, portal);
    bench::add_lights(scene, lamps);
    if (haze > 0) scene.medium = render::make_medium("haze", {{"extinction", haze}});
    using Clock = std::chrono::steady_clock;
    Clock::time_point start = Clock::now();
    double preparing = 0;
    const auto processor = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
    const double before = processor();
    Progress progress([&](const std::string& stage, double fraction) {
      if (stage == "rendering" && fraction == 0)
        preparing = std::chrono::duration<double>(Clock::now() - start).count();
    });
    const image::Image picture = render::render(scene, options, progress);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count() - preparing;
    const double spent = processor() - before;
    if (!out.empty()) image::write_exr(out, picture);
    fmt::print(
        "{{\"prepare_s\": {:.3f}, \"render_s\": {:.3f}, \"msamples_per_s\": {:.4f}, "
        "\"processor_s\": {:.3f}}}\n",
        preparing, seconds, 1e-6 * options.width * options.height * options.spp / seconds, spent);
  } catch (const Error& error) {
    fmt::print(stderr, "bench_cave: {}\n", error.what());
    return 2;
  }
  return 0;
}
