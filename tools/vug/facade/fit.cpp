// SPDX-License-Identifier: Apache-2.0
// vug facade fit: fits a grammar to a photograph and writes its tree, scene and pictures, all or
// none.
#include "arguments.h"
#include "file_transaction.h"
#include "fit_summary.h"
#include "output_files.h"
#include "progress_bar.h"
#include "scene_options.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/facade/tree_output.h>
#include <vug/fit/learning/labelling.h>
#include <vug/image/io.h>
#include <vug/loading/load.h>
#include <vug/scan/read.h>
#include <vug/scan/report.h>
#include <vug/session/facade_fit.h>
#include <vug/session/facade_model.h>

#include <algorithm>
#include <cstdio>

namespace vug::cli {
namespace {

namespace fs = std::filesystem;

struct FacadeFitOptions {
  std::string photo, folder, name, grammar, classifier, likelihood, crop;
  std::vector<std::string> clouds;
  session::FacadePictureOptions picture;
  session::FacadeFitOptions fit;
  scan::PlaneOptions plane;
  WorkOptions work;
  bool no_carving = false;

  const std::string& first_input() const { return photo.empty() ? clouds.front() : photo; }
};

/// The picture to be fitted, and the range image if the input contains a point cloud.
struct Input {
  session::FacadePicture picture;
  std::optional<scan::RangeImage> range;
};

Input read_input(const FacadeFitOptions& options) {
  Input in;
  if (!options.clouds.empty()) {
    const scan::PointCloud cloud = scan::read_clouds({options.clouds.begin(), options.clouds.end()},
                                                     {.memory = options.work.memory_limit()});
    const RandomKey key = RandomKey(options.fit.seed).at("facade fit");
    const scan::PlaneFit plane = scan::fit_plane(cloud, options.plane, key.at("plane"));
    scan::RangeOptions range;
    range.memory = options.work.memory_limit();
    in.range = scan::range_image(cloud, plane, range);
    print_quality_warnings(cloud, plane, *in.range);
    if (!options.work.quiet) {
      clear_progress_bar();
      fmt::print(stderr, "the wall is a plane within {:.1f} cm of {} of {} points\n",
                 100 * plane.rms, plane.inliers, cloud.size());
    }
  }
  in.picture = options.photo.empty() ? session::facade_picture(*in.range, options.picture.limits)
                                     : session::read_facade_picture(options.photo, options.picture);
  if (in.range && !options.photo.empty()) session::add_depth(in.picture, *in.range);
  return in;
}

/// The file given by --grammar, found like that of a session; default: the paper's grammar.
fs::path grammar_file(const FacadeFitOptions& options) {
  if (fs::exists(options.grammar)) return options.grammar;
  return session::find_grammar_file({}, options.grammar.empty() ? "ripperda.vug" : options.grammar);
}

/// Whether the photo is the only evidence, without depth.
bool is_photo_alone(const FacadeFitOptions& options) {
  if (!options.clouds.empty() || !options.picture.depth.empty()) return false;
  const std::vector<std::string> channels = image::read_info(options.photo).channels;
  return std::none_of(channels.begin(), channels.end(), [](const std::string& channel) {
    return channel == "depth" || channel == "Z";
  });
}

/// The file of the pixel classifier: that of --looks, else the default one for a photo alone. Empty
/// for none, and for a likelihood of colour clusters.
fs::path looks_file(const FacadeFitOptions& options) {
  if (options.classifier == "none") return {};
  if (!options.classifier.empty()) return options.classifier;
  if (!options.likelihood.empty() || !is_photo_alone(options)) return {};
  return session::default_looks();
}

/// Whether neither the options nor the input determine the size of the facade.
bool has_assumed_size(const FacadeFitOptions& options, const session::FacadePicture& picture) {
  return options.fit.width == 0 && options.fit.height == 0 && picture.metres_wide == 0;
}

/// Prints the assumed size of the facade if no size is given.
void print_assumed_size(const FacadeFitOptions& options, const session::FacadePicture& picture) {
  const Vec2d size = session::facade_size(picture, options.fit);
  if (options.work.quiet || !has_assumed_size(options, picture)) return;
  clear_progress_bar();
  fmt::print(stderr, "assumed size {:.4g} x {:.4g} m; --width or --height set another size\n",
             size.x, size.y);
}

/// The output files of that name in a folder.
struct FitFiles {
  fs::path grammar, scene, tree, drawing, carved, seen, range, labels, report, charts;

  FitFiles(const fs::path& folder, const std::string& name) {
    const auto file = [&](const char* ending) { return folder / (name + ending); };
    grammar = file(".vug"), scene = file("_scene.vug"), tree = file(".json");
    drawing = file(".svg"), carved = file(".vdb");
    seen = file(".depth.png"), range = file(".depth.exr"), labels = file(".labels.png");
    report = file(".report.json"), charts = file(".report.svg");
  }

  /// The files for the summary.
  std::vector<NamedFile> named(bool carves) const {
    std::vector<NamedFile> out = {{"grammar", grammar}, {"scene", scene},   {"tree", tree},
                                  {"drawing", drawing}, {"labels", labels}, {"depth", range},
                                  {"report", report},   {"charts", charts}};
    if (carves) out.push_back({"carving", carved});
    return out;
  }
};

/// The part of the photo that is used, in its pixels.
scan::PixelBox photo_box(const FacadeFitOptions& options) {
  if (options.picture.crop) return *options.picture.crop;
  const image::FileInfo photo = image::read_info(options.photo);
  return {0, 0, photo.width, photo.height};
}

/// The background of the drawing: the photo, or the picture of the scan.
facade::SvgOptions background(const FacadeFitOptions& options, const FitFiles& to,
                              const fs::path& folder) {
  if (options.photo.empty()) return {.picture = to.seen.filename().string()};
  facade::SvgOptions out{.picture = relative_path_from(folder, options.photo)};
  if (!options.picture.crop) return out;
  const image::FileInfo photo = image::read_info(options.photo);
  const scan::PixelBox& box = *options.picture.crop;
  out.part = {static_cast<double>(box.x0) / photo.width, static_cast<double>(box.y0) / photo.height,
              static_cast<double>(box.x1 - box.x0) / photo.width,
              static_cast<double>(box.y1 - box.y0) / photo.height};
  return out;
}

/// Writes all files but the carved volume. Paths of pictures are relative to `folder`.
void write_results(const FacadeFitOptions& options, const Input& in, const session::FacadeFit& fit,
                   const FitFiles& to, const fs::path& folder) {
  if (in.range) {
    scan::write_range(to.range, *in.range);
    image::write_png(to.seen, scan::picture_of(*in.range, scan::surface_map(*in.range)),
                     image::plain_view());
  }
  if (!fit.labels.empty()) {
    const scan::PixelBox box = photo_box(options);
    const int width = box.x1 - box.x0, height = box.y1 - box.y0;
    image::write_grey_png(
        to.labels,
        fit::resampled(fit.labels, {in.picture.width, in.picture.height}, {width, height}), width,
        height);
  }
  write_text(to.grammar,
             fmt::format("# Read from {}.\n{}", fs::path(options.first_input()).filename().string(),
                         session::facade_grammar(fit, options.name)));
  write_text(to.scene, session::facade_scene(fit, options.name, to.grammar.filename().string()));
  write_text(to.tree, facade::tree_json(fit.tree));
  write_text(to.drawing, facade::elevation_svg(fit.tree, background(options, to, folder)));
  write_text(to.report, fit::report_json(fit.reading.report));
  write_text(to.charts, fit::report_svg(fit.reading.report));
}

void warn_of_stale_carving(const fs::path& carved) {
  if (!fs::exists(carved)) return;
  clear_progress_bar();
  fmt::print(stderr, "warning: '{}' is from an earlier fit\n", carved.string());
}

/// Writes all files in one transaction, so that a full disk leaves none of them. A carving that is
/// cancelled or too large is omitted.
void write_fit(const FacadeFitOptions& options, const Input& in, const session::FacadeFit& fit,
               const FitFiles& files, bool carve) {
  FileTransaction transaction(options.folder, options.name);
  const FitFiles staged(transaction.path(), options.name);
  try {
    write_results(options, in, fit, staged, options.folder);
    if (carve)
      write_carving(
          loading::load_text(session::facade_scene(fit, options.name, {}), files.scene.string()),
          options.work, staged.carved);
  } catch (Error& error) {
    if (error.code() != ErrorCode::io && fs::exists(staged.charts)) {
      transaction.commit();
      warn_of_stale_carving(files.carved);
      throw;
    }
    error.within("writing the results, none of which are kept");
    throw;
  }
  transaction.commit();
}

int run_facade_fit(FacadeFitOptions options) {
  if (options.photo.empty() && options.clouds.empty())
    throw Error(ErrorCode::bad_input, "no input given", {},
                "pass a picture, or a scan with --cloud");
  if (!options.clouds.empty() && !options.picture.depth.empty())
    throw Error(ErrorCode::bad_input, "--depth and --cloud exclude each other", {},
                "remove one of them");
  if (!options.clouds.empty() && (options.fit.width > 0 || options.fit.height > 0))
    throw Error(ErrorCode::bad_input,
                "--width and --height do not apply to a scan, which has a size", {},
                "remove --width and --height");
  if (!options.crop.empty()) {
    if (options.photo.empty())
      throw Error(ErrorCode::bad_input, "--crop applies to a photo, and none is given", {},
                  "remove --crop");
    const std::vector<int> crop = parse_crop(options.crop);
    options.picture.crop = scan::PixelBox{crop[0], crop[1], crop[2], crop[3]};
  }
  Progress& progress = terminal_progress(options.work.bar_mode());
  const fs::path folder = options.folder;
  options.fit.grammar = grammar_file(options);
  const bool named = !options.name.empty();
  const std::string wanted = named ? options.name : fs::path(options.first_input()).stem().string();
  options.name = valid_grammar_name(wanted);
  if (options.name != wanted && !options.work.quiet)
    fmt::print(stderr, "the output is named '{}', because '{}' is not a valid name in scenes\n",
               options.name, wanted);
  const FitFiles files(folder, options.name);
  std::vector<fs::path> outputs = {files.grammar, files.scene,  files.tree,
                                   files.drawing, files.report, files.charts};
  if (!options.no_carving) outputs.push_back(files.carved);
  if (!options.clouds.empty()) outputs.insert(outputs.end(), {files.range, files.seen});
  const fs::path looks = looks_file(options);
  if (!looks.empty()) outputs.push_back(files.labels);
  std::vector<fs::path> inputs(options.clouds.begin(), options.clouds.end());
  for (const fs::path& one :
       {fs::path(options.photo), options.picture.depth, looks, options.fit.grammar})
    if (!one.empty()) inputs.push_back(one);
  require_outputs(outputs, inputs);
  if (options.clouds.size() > 1 && options.photo.empty() && !named && !options.work.quiet)
    fmt::print(
        stderr,
        "the {} files form one scan; the output is named '{}', because --name is not given\n",
        options.clouds.size(), options.name);

  options.picture.max_memory = options.work.memory_limit();
  if (!options.likelihood.empty()) options.fit.likelihood = options.likelihood;
  if (!looks.empty()) {
    options.fit.classifier =
        std::make_shared<const fit::PixelClassifier>(fit::PixelClassifier::read(looks));
    options.picture.limits = options.fit.classifier->limits();
  }
  const Input in = read_input(options);
  print_assumed_size(options, in.picture);
  const session::FacadeFit fit = session::fit_facade(in.picture, options.fit, progress);
  const bool stopped = fit.reading.report.stopped;
  write_fit(options, in, fit, files, !options.no_carving && !stopped);
  clear_progress_bar();
  if (stopped) fmt::print(stderr, "stopped: this is the best tree so far; it was not carved\n");
  if (stopped || options.no_carving) warn_of_stale_carving(files.carved);
  if (const auto warning = fit::disagreement(fit.reading.report))
    fmt::print(stderr, "warning: {}\nhint: {}\n", warning->message, warning->hint);
  if (fit.reading.elements.empty())
    fmt::print(stderr, "no elements were found: the facade is a bare wall\n");
  fmt::print("{}", fit_summary(fit, has_assumed_size(options, in.picture),
                               files.named(!stopped && !options.no_carving)));
  return stopped ? kFailed : kDone;
}

}  // namespace

Verb facade_fit_verb() {
  return {
      "fit", "Finds the most likely derivation tree of a facade grammar for a picture or scan.",
      [](CLI::App& app) {
        auto options = std::make_shared<FacadeFitOptions>();
        app.add_option("photo", options->photo,
                       "Rectified upright picture in any format, e.g. an EXR with a depth layer");
        app.add_option("--cloud", options->clouds,
                       "PLY or text files of points, which together form one scan")
            ->expected(-1);
        app.add_option("-o,--output", options->folder, "Output folder")->required();
        app.add_option("--name", options->name,
                       "Name of the output files and the grammar; default: that of the photo");
        app.add_option("--depth", options->picture.depth,
                       "EXR with the depth of the wall's parts in a layer depth or Z");
        app.add_option("--crop", options->crop,
                       "Part of the photo with the facade, LEFT,TOP,RIGHT,BOTTOM in pixels; right "
                       "and bottom are exclusive");
        app.add_option("--width", options->fit.width,
                       "Width of the facade; default from the picture's header, else 12m")
            ->transform(number_in(Dimension::length, 0.1, 1e4));
        app.add_option("--height", options->fit.height,
                       "Height of the facade; default from the proportions of the picture")
            ->transform(number_in(Dimension::length, 0.1, 1e4));
        app.add_option("--rows", options->picture.limits.height,
                       "Number of pixel rows to which the picture is reduced")
            ->transform(integer_in(session::kMinPixels, 4096));
        app.add_option("--grammar", options->grammar,
                       "Grammar file with free sizes; default ripperda.vug");
        app.add_option("--likelihood", options->likelihood,
                       "Likelihood model of clusters of colours or depths: kt or paper; default kt")
            ->check(one_of({"kt", "paper"}));
        app.add_option("--looks", options->classifier,
                       "Pixel classifier trained by 'vug facade train', or 'none' for clusters of "
                       "colours; default for photos without depth: the one of data/facades");
        app.add_option(
               "--trust", options->fit.trust,
               "Weight of a pixel; below 1, because neighbouring pixels are not independent")
            ->transform(number_in(Dimension::none, 1e-4, 10));
        app.add_option("--depths", options->fit.clusters.depth_clusters, "Number of depth clusters")
            ->transform(integer_in(2, 7));
        app.add_option("--iterations,--steps", options->fit.sampler.steps,
                       "Number of iterations per chain; default 1000000")
            ->transform(integer_in(1, 1000000000));
        app.add_option("--chains", options->fit.sampler.chains,
                       "Number of chains at different temperatures")
            ->transform(integer_in(1, 64));
        app.add_option("--seed", options->fit.seed, "Seed of the chains")->transform(seed_number());
        app.add_flag("--no-carving", options->no_carving, "Do not write the carved .vdb");
        options->work.add_to(app);
        return [options] {
          return with_threads(options->work.threads, [&] { return run_facade_fit(*options); });
        };
      }};
}

}  // namespace vug::cli
