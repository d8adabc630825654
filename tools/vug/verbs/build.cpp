// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"
#include "product_report.h"
#include "progress_bar.h"
#include "scene_at_frame.h"
#include "scene_options.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/building/cells_checkpoint.h>
#include <vug/delivery/tiles.h>
#include <vug/delivery/write_products.h>
#include <vug/loading/dependencies.h>
#include <vug/picture/frame_sequence.h>

#include <charconv>
#include <cstdio>
#include <memory>

namespace vug::cli {
namespace {

struct BuildOptions {
  SceneOptions scene;
  WorkOptions work;
  std::string folder;
  std::string frames;
  std::string checkpoint;
  bool explain = false;
  bool in_tiles = false;
  int tile_edge = 0;  // In voxels.
  int levels = 0;
  std::string usd_format = "usda";
  std::vector<std::string> only;
  building::CheckpointOptions keep;
};

Vec3i parse_tile(const std::string& text) {
  Vec3i out;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (int axis = 0; axis < 3; ++axis) {
    const auto [stop, error] = std::from_chars(at, end, out[axis]);
    const bool last = axis == 2;
    if (error != std::errc() || (last ? stop != end : stop == end || *stop != ','))
      throw Error(ErrorCode::bad_input, fmt::format("'{}' does not name a tile", text), {},
                  "give its three numbers as in index.json: --tile 0,-1,2");
    at = stop + (last ? 0 : 1);
  }
  return out;
}

void build_tiles(const BuildOptions& options, building::Builder& builder,
                 const loading::Loaded& loaded, int edge) {
  delivery::TileOptions tiles{edge, {}, options.levels, options.usd_format};
  for (const std::string& text : options.only) tiles.only.push_back(parse_tile(text));
  if (loaded.shot.volumes.empty())
    throw Error(ErrorCode::bad_input,
                fmt::format("'{}' declares no volume to divide into tiles", options.scene.scene),
                {}, "add, for instance: volume rock = level_set(..., voxel: 5cm)");
  require_outputs({delivery::tile_folder(loaded.shot, options.folder) / "index.json"},
                  loading::file_dependencies(loaded));
  const delivery::TilesReport report = delivery::write_tiles(builder, options.folder, tiles);
  clear_progress_bar();
  for (const std::string& each : report.levels) fmt::print(stderr, "{}\n", each);
  for (const auto& path : report.files) fmt::print("{}\n", path.string());
}

/// Writes the products of the loaded scene. `frame` is empty unless a sequence is built.
void build_one(const BuildOptions& options, building::Builder& builder,
               const loading::Loaded& loaded, const std::string& frame) {
  std::vector<std::filesystem::path> outputs =
      delivery::product_paths(loaded.shot, options.folder, frame);
  if (outputs.empty())
    throw Error(ErrorCode::bad_input,
                fmt::format("'{}' declares nothing to build", options.scene.scene), {},
                "add, for instance: volume rock = level_set(..., voxel: 5cm)");
  if (!options.checkpoint.empty()) outputs.emplace_back(options.checkpoint);
  require_outputs(outputs, loading::file_dependencies(loaded));
  for (const auto& path : delivery::write_products(builder, options.folder, frame))
    fmt::print("{}\n", path.string());
}

int build_frames(const BuildOptions& options, Progress& progress) {
  const std::vector<int> frames = picture::parse_frames(options.frames);
  const loading::SceneSource source = options.scene.source();
  std::unique_ptr<SceneAtFrame> now;
  for (size_t i = 0; i < frames.size(); ++i) {
    auto next = std::make_unique<SceneAtFrame>(options.scene.load(source, frames[i]), options.work,
                                               progress);
    if (now) next->builder.reuse_from(std::move(now->builder));
    now = std::move(next);
    if (!options.work.quiet) {
      clear_progress_bar();
      fmt::print(stderr, "frame {}, {} of {}\n", frames[i], i + 1, frames.size());
    }
    try {
      build_one(options, now->builder, now->loaded, fmt::format("{:04}", frames[i]));
    } catch (Error& error) {
      throw error.within(fmt::format("building frame {}", frames[i]));
    }
  }
  options.work.summarise(now->builder);
  return kDone;
}

int run_build(BuildOptions options) {
  if (options.keep.resume && options.checkpoint.empty())
    throw Error(ErrorCode::bad_input, "--resume requires a checkpoint", {},
                "name the file with --checkpoint");
  if (!options.checkpoint.empty())
    require_extension(options.checkpoint, ".vdb", "a checkpoint of cells is a VDB file of points");
  Progress& progress = terminal_progress(options.work.bar_mode());
  if (!options.frames.empty()) return build_frames(options, progress);
  const loading::Loaded loaded = options.scene.load();
  building::BuildOptions build = options.work.build_options(loaded);
  if (options.explain)
    build.stored.on_product = [](const building::ProductReport& report) {
      clear_progress_bar();
      fmt::print(stderr, "{}\n", to_text(report));
    };
  options.keep.file = options.checkpoint;
  if (!options.checkpoint.empty())
    build.checkpoint = std::make_shared<building::CellsCheckpoint>(options.keep, loaded.shot);
  building::Builder builder(loaded.shot, build, progress);
  if (options.in_tiles)
    build_tiles(options, builder, loaded, options.tile_edge);
  else
    build_one(options, builder, loaded, "");
  std::fflush(stdout);
  if (build.checkpoint) build.checkpoint->remove();
  options.work.summarise(builder);
  return kDone;
}

}  // namespace

Verb build_verb() {
  return {
      "build", "Builds everything a scene declares: VDB volumes, meshes and points.",
      [](CLI::App& app) {
        auto options = std::make_shared<BuildOptions>();
        options->scene.add_to(app, &options->work);
        app.add_option("-o,--output", options->folder, "Output folder")->required();
        auto* checkpoint = app.add_option("--checkpoint", options->checkpoint,
                                          "Checkpoint file of cell simulations, a .vdb");
        app.add_option("--checkpoint-every", options->keep.every,
                       "Interval between checkpoints in seconds")
            ->transform(number_in(Dimension::time, 0, 1e6))
            ->needs(checkpoint);
        app.add_flag("--resume", options->keep.resume, "Continue from the checkpoint if it exists");
        app.add_option("--frames", options->frames,
                       "Frames to build, A..B or A..BxSTEP; file names contain the frame number")
            ->excludes("--frame")
            ->excludes(checkpoint);
        app.add_flag("--explain", options->explain,
                     "Report for each level set and mesh whether it was built or reused, and why")
            ->excludes("--frames");
        auto* tiles = app.add_flag("--tiles{1024}", options->tile_edge,
                                   "Build in tiles of that many voxels, one after the other, which "
                                   "needs the memory of one tile. Writes a folder NAME.tiles")
                          ->excludes("--frames")
                          ->excludes(checkpoint);
        app.add_option("--tile", options->only,
                       "Only the tile with these numbers, I,J,K; may be repeated")
            ->needs(tiles)
            ->expected(1)
            ->take_all();
        constexpr int kMostLevels = 12;
        auto* lods =
            app.add_option(
                   "--lods", options->levels,
                   "Number of levels of detail of each tile in addition to the full mesh, each "
                   "with a quarter of the triangles, and a USD assembly of the tiles")
                ->needs(tiles)
                ->check(CLI::Range(0, kMostLevels));
        app.add_option("--usd-format", options->usd_format,
                       "Format of the USD files: usda (text, the default) or usdc (binary)")
            ->needs(lods)
            ->check(one_of({"usda", "usdc"}));
        options->work.add_to(app);
        return [options, tiles] {
          options->in_tiles = tiles->count() > 0;
          return with_threads(options->work.threads, [&] { return run_build(*options); });
        };
      }};
}

}  // namespace vug::cli
