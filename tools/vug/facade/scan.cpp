// SPDX-License-Identifier: Apache-2.0
// vug facade scan: finds the plane, the range image, the windows and the doors of a laser scan.
#include "arguments.h"
#include "file_transaction.h"
#include "output_files.h"
#include "print.h"
#include "progress_bar.h"
#include "scene_options.h"

#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/image/io.h>
#include <vug/scan/read.h>
#include <vug/scan/report.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace vug::cli {
namespace {

namespace fs = std::filesystem;

struct FacadeScanOptions {
  std::vector<std::string> clouds;
  std::string output, windows = "raster", up = "z";
  std::vector<double> scanner;
  scan::PlaneOptions plane;
  scan::RangeOptions range;
  scan::SurfaceOptions surfaces;
  scan::OpeningOptions openings;
  uint64_t seed = 0;
  bool nearest = false, plain = false, json = false;
  WorkOptions work;
};

/// The output files, which share the stem of the range image.
struct ScanFiles {
  fs::path range, picture, drawing, report;

  explicit ScanFiles(const fs::path& exr)
      : range(exr),
        picture(fs::path(exr).replace_extension(".png")),
        drawing(fs::path(exr).replace_extension(".svg")),
        report(fs::path(exr).replace_extension(".json")) {}
};

/// Writes all output files in one transaction.
void write_scan(const fs::path& exr, const scan::RangeImage& range, const scan::SurfaceMap& map,
                const std::vector<scan::Opening>& openings, const std::string& report) {
  FileTransaction transaction(exr.parent_path(), exr.stem().string());
  const ScanFiles outputs(transaction.path() / exr.filename());
  scan::write_range(outputs.range, range);
  image::write_png(outputs.picture, scan::picture_of(range, map), image::plain_view());
  write_text(outputs.drawing,
             scan::openings_svg(range, openings, outputs.picture.filename().string()));
  write_text(outputs.report, report);
  transaction.commit();
}

int run_facade_scan(FacadeScanOptions options) {
  Progress& progress = terminal_progress(options.work.bar_mode());
  if (!options.output.empty()) {
    require_extension(options.output, ".exr", "the range image is an EXR");
    const ScanFiles outputs(options.output);
    require_outputs({outputs.range, outputs.picture, outputs.drawing, outputs.report},
                    {options.clouds.begin(), options.clouds.end()});
  }
  if (options.up == "y") options.plane.up = {0, 1, 0};
  for (const double c : options.scanner)
    if (!std::isfinite(c))
      throw Error(ErrorCode::bad_input, "the position of the scanner is not finite", {},
                  "write --scanner X,Y,Z");
  if (options.openings.min_size > options.openings.max_size)
    throw Error(ErrorCode::bad_input, "--min is greater than --max: no opening would be found");
  if (!options.scanner.empty())
    options.plane.scanner = Vec3d(options.scanner[0], options.scanner[1], options.scanner[2]);
  if (options.nearest) options.range.depth = scan::DepthStatistic::nearest;
  if (options.plain) options.surfaces.bent = options.openings.tidy = false;
  options.range.memory = options.openings.memory = options.work.memory_limit();

  const scan::PointCloud cloud = scan::read_clouds({options.clouds.begin(), options.clouds.end()},
                                                   {.memory = options.range.memory});
  progress.check();
  const scan::PlaneFit plane =
      scan::fit_plane(cloud, options.plane, RandomKey(options.seed).at("plane"));
  progress.check();
  const scan::RangeImage range = scan::range_image(cloud, plane, options.range);
  progress.check();
  const scan::SurfaceMap map = scan::surface_map(range, options.surfaces);
  std::vector<scan::Opening> openings;
  if (options.windows == "raster")
    openings = scan::openings_by_raster(range, map, options.openings);
  if (options.windows == "delaunay")
    openings = scan::openings_by_triangles(cloud, range, map, options.openings);
  progress.check();
  print_quality_warnings(cloud, plane, range);
  const std::string report = scan::report_json(cloud, plane, range, map, openings);
  if (!options.output.empty()) write_scan(options.output, range, map, openings, report);
  clear_progress_bar();
  print_report(nlohmann::ordered_json::parse(report), options.json);
  return kDone;
}

void add_plane_options(CLI::App& app, FacadeScanOptions& o) {
  app.add_option("--up", o.up, "Up axis of the cloud: y or z; default z")
      ->check(one_of({"y", "z"}));
  app.add_option("--tolerance", o.plane.tolerance,
                 "Maximum distance of points from the plane; default 10cm")
      ->transform(number_in(Dimension::length, 1e-6, 1e3));
  app.add_option("--lean", o.plane.max_lean,
                 "Maximum angle of the plane to the vertical; default 20deg")
      ->transform(number_in(Dimension::angle, 0, kPi / 2));
  app.add_option("--scanner", o.scanner,
                 "Position of the scanner, X,Y,Z; determines the front side")
      ->delimiter(',')
      ->expected(3);
  app.add_flag("--flip", o.plane.flip, "Swap the front side and the back side");
}

void add_range_options(CLI::App& app, FacadeScanOptions& o) {
  app.add_option("--pixel", o.range.pixel, "Pixel size of the range image; default 1cm")
      ->transform(number_in(Dimension::length, 1e-6, 1e3));
  app.add_flag("--nearest", o.nearest,
               "Use the depth of the nearest point of a pixel instead of the median");
  app.add_option("--before", o.range.before,
                 "Maximum distance of points in front of the plane; default 50cm")
      ->transform(number_in(Dimension::length, 0, 1e3));
  app.add_option("--behind", o.range.behind,
                 "Maximum distance of points behind the plane; default 1m")
      ->transform(number_in(Dimension::length, 0, 1e3));
  app.add_option("--fill", o.range.inpaint_radius,
                 "Maximum distance over which empty pixels are filled; default: about the distance "
                 "between points")
      ->transform(number_in(Dimension::length, 0, 1e3));
}

void add_opening_options(CLI::App& app, FacadeScanOptions& o) {
  app.add_option("--windows", o.windows, "Method that finds openings: raster, delaunay or none")
      ->check(one_of({"raster", "delaunay", "none"}));
  app.add_option("--set-back", o.surfaces.set_back,
                 "Minimum depth of openings behind the wall; default from the wall's roughness")
      ->transform(number_in(Dimension::length, 0, 1e3));
  app.add_option("--min", o.openings.min_size,
                 "Minimum width and height of an opening; default 50cm")
      ->transform(number_in(Dimension::length, 0, 1e3));
  app.add_option("--max", o.openings.max_size, "Maximum width and height of an opening; default 6m")
      ->transform(number_in(Dimension::length, 0, 1e3));
  app.add_flag("--plain", o.plain,
               "Use only the methods of the paper: a planar wall and openings as found");
}

}  // namespace

Verb facade_scan_verb() {
  return {"scan", "Finds the plane, the depths, the windows and the doors of a scanned facade.",
          [](CLI::App& app) {
            auto o = std::make_shared<FacadeScanOptions>();
            app.add_option("cloud", o->clouds,
                           "PLY files or text files of x y z; several files form one scan")
                ->required();
            app.add_option(
                "-o,--output", o->output,
                "Output range image, an .exr; a picture, a drawing and the report are written "
                "next to it");
            add_plane_options(app, *o);
            add_range_options(app, *o);
            add_opening_options(app, *o);
            app.add_option("--seed", o->seed, "Seed of the search for the plane")
                ->transform(seed_number());
            app.add_flag("--json", o->json, "Machine-readable report");
            o->work.add_to(app);
            return
                [o] { return with_threads(o->work.threads, [&] { return run_facade_scan(*o); }); };
          }};
}

}  // namespace vug::cli
