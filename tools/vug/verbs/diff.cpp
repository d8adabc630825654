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

struct Options {
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

void require_files(const Options& options) {
  if (!options.heat.empty()) require_extension(options.heat, ".png", "the heat map is a PNG");
  std::vector<std::filesystem::path> outputs, inputs;
  for (const std::string& path : {options.json, options.html, options.heat})
    if (!path.empty()) outputs.emplace_back(path);
  for (const std::string& path :
       {options.reference, options.test, options.mask, options.thresholds})
    if (!path.empty()) inputs.emplace_back(path);
  require_outputs(outputs, inputs);
}

/// What is limits twice, one of them in vain.
void require_distinct(const std::vector<image::Limit>& limits) {
  for (auto a = limits.begin(); a != limits.end(); ++a)
    for (auto b = limits.begin(); b != a; ++b)
      if (a->layer == b->layer && a->measure == b->measure)
        throw Error(ErrorCode::bad_input,
                    fmt::format("there are two limits of {}{}{}", a->layer,
                                a->layer.empty() ? "" : ".", a->measure),
                    {}, "leave out one of them");
}

int run(Options options) {
  const ThreadLimit threads(options.threads);
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
      "diff", "Compares two pictures; exit 1 when they differ by more than limits or noise allow.",
      [](CLI::App& app) {
        auto o = std::make_shared<Options>();
        app.add_option("reference", o->reference, "the picture that is right")->required();
        app.add_option("test", o->test, "the picture to be judged")->required();
        app.add_option("--max", o->maxima, "[LAYER.]MEASURE=VALUE that is allowed at most")
            ->take_all()
            ->type_name("LIMIT");
        app.add_option("--min", o->minima, "the same for psnr and ssim, where more is better")
            ->take_all()
            ->type_name("LIMIT");
        app.add_option("--thresholds", o->thresholds,
                       "a JSON file of limits: {\"rmse\": 0.01, \"N.max\": 0.1}");
        app.add_option("--alarm", o->diff.false_alarm_rate,
                       "demands the test of significance, at this rate of false alarms (0.01)")
            ->transform(number_in(Dimension::ratio, 1e-9, 0.5));
        app.add_option("--layer", o->diff.layers, "compare these layers only, e.g. beauty,albedo")
            ->delimiter(',');
        app.add_option("--metric", o->diff.measures, "measure these only: " + measure_names())
            ->delimiter(',');
        app.add_option("--mask", o->mask, "a picture that is 0.5 or more where pixels count");
        app.add_option("--exposure", o->diff.exposure,
                       "stops at which an eye looks; else that makes middle grey")
            ->transform(number_in(Dimension::none, -30, 30));
        app.add_flag("--reference-exposures", o->diff.reference_exposures,
                     "flip_hdr takes its exposures from the reference alone, as its paper does");
        app.add_option("--json", o->json, "writes the verdict for programs");
        app.add_option("--html", o->html, "writes a page with both pictures and the heat map");
        app.add_option("--heat", o->heat, "writes the heat map, a PNG");
        app.add_option("--threads", o->threads, "threads to use; 0: all cores")
            ->check(integer_in(0, 1024));
        app.add_flag("--quiet,-q", o->quiet, "no table: the exit code is the answer");
        return [o] { return run(*o); };
      }};
}

}  // namespace vug::cli
