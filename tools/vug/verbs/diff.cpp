// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"
#include "diff_limits.h"
#include "verb.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/image/io.h>
#include <vug/image/report.h>

namespace vug::cli {
namespace {

struct DiffOptions {
  std::string reference, test;
  image::DiffOptions diff;
  std::vector<std::string> maxima, minima;
  std::string thresholds, mask, json, html, heat;
  int threads = 0;
  bool quiet = false;
};

std::string measure_names() {
  std::string out;
  for (const image::Measure* each : image::measures())
    out += (out.empty() ? "" : ", ") + each->info.name;
  return out;
}

void require_files(const DiffOptions& options) {
  if (!options.heat.empty()) require_extension(options.heat, ".png", "the heat map is a PNG");
  std::vector<std::filesystem::path> outputs, inputs;
  for (const std::string& path : {options.json, options.html, options.heat})
    if (!path.empty()) outputs.emplace_back(path);
  for (const std::string& path :
       {options.reference, options.test, options.mask, options.thresholds})
    if (!path.empty()) inputs.emplace_back(path);
  require_outputs(outputs, inputs);
}

/// Error(bad_input) if two limits apply to the same layer and measure.
void require_distinct(const std::vector<image::Limit>& limits) {
  for (auto a = limits.begin(); a != limits.end(); ++a)
    for (auto b = limits.begin(); b != a; ++b)
      if (a->layer == b->layer && a->measure == b->measure)
        throw Error(ErrorCode::bad_input,
                    fmt::format("duplicate limit for {}{}{}", a->layer, a->layer.empty() ? "" : ".",
                                a->measure),
                    {}, "remove one of them");
}

int run_diff(DiffOptions options) {
  using Better = image::Measure::Better;
  if (!options.thresholds.empty()) options.diff.limits = read_limits(options.thresholds);
  std::vector<image::Limit> limits;
  for (const std::string& text : options.maxima) limits.push_back(parse_limit(text, Better::low));
  for (const std::string& text : options.minima) limits.push_back(parse_limit(text, Better::high));
  require_distinct(limits);
  options.diff.limits.insert(options.diff.limits.end(), limits.begin(), limits.end());
  for (const std::string& name : options.diff.measures) image::measure_of(name);
  require_files(options);
  const image::ImageUnderTest reference = image::read_image_under_test(options.reference);
  const image::ImageUnderTest test = image::read_image_under_test(options.test);
  if (!options.mask.empty())
    options.diff.mask =
        image::read_mask(options.mask, reference.image.width, reference.image.height);
  const image::Diff diff = image::diff(reference, test, options.diff);
  if (!options.quiet) fmt::print("{}", image::to_table(diff));
  if (!options.json.empty()) write_text(options.json, to_json(diff, reference.name, test.name));
  if (!options.html.empty())
    write_text(options.html, to_html(diff, std::filesystem::path(options.test).filename().string(),
                                     reference.name, test.name));
  if (!options.heat.empty())
    image::write_png(options.heat, heat_picture(diff), image::plain_view());
  return diff.same ? kDone : kAnswerNo;
}

}  // namespace

Verb diff_verb() {
  return {
      "diff",
      "Compares two pictures; exit code 1 if they differ by more than limits or noise allow.",
      [](CLI::App& app) {
        auto o = std::make_shared<DiffOptions>();
        app.add_option("reference", o->reference, "Reference picture")->required();
        app.add_option("test", o->test, "Picture to be compared with the reference")->required();
        app.add_option("--max", o->maxima, "Upper limit of a measure, [LAYER.]MEASURE=VALUE")
            ->take_all()
            ->type_name("LIMIT");
        app.add_option("--min", o->minima,
                       "Lower limit of psnr or ssim, for which higher values are better")
            ->take_all()
            ->type_name("LIMIT");
        app.add_option("--thresholds", o->thresholds,
                       "JSON file of limits: {\"rmse\": 0.01, \"N.max\": 0.1}");
        app.add_option("--alarm", o->diff.false_alarm_rate,
                       "Require the significance test, with this false-alarm rate; default 0.01")
            ->transform(number_in(Dimension::ratio, 1e-9, 0.5));
        app.add_option("--layer", o->diff.layers,
                       "Layers to compare, e.g. beauty,albedo; default all")
            ->delimiter(',');
        app.add_option("--metric", o->diff.measures,
                       "Measures to compute; default all: " + measure_names())
            ->delimiter(',');
        app.add_option("--mask", o->mask,
                       "Mask picture; pixels with values of at least 0.5 are compared");
        app.add_option(
               "--exposure", o->diff.exposure,
               "Exposure of perceptual measures in stops; default: the mean becomes middle grey")
            ->transform(number_in(Dimension::none, -30, 30));
        app.add_flag("--reference-exposures", o->diff.reference_exposures,
                     "Take the exposures of flip_hdr from the reference alone, as in its paper");
        app.add_option("--json", o->json, "Write the result to this JSON file");
        app.add_option("--html", o->html, "Write a page with both pictures and the heat map");
        app.add_option("--heat", o->heat, "Write the heat map to this PNG file");
        app.add_option("--threads", o->threads, "Number of threads; 0 uses all cores")
            ->check(integer_in(0, 1024));
        app.add_flag("--quiet,-q", o->quiet, "No table; the exit code is the result");
        return [o] { return with_threads(o->threads, [&] { return run_diff(*o); }); };
      }};
}

}  // namespace vug::cli
