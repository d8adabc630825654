// SPDX-License-Identifier: Apache-2.0
#include "error_report.h"
#include "plot.h"
#include "progress_bar.h"
#include "scene_options.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/delivery/measure.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace vug::cli {
namespace {

struct SweepOptions {
  SceneOptions scene;
  WorkOptions work;
  std::string param;
  std::vector<std::string> values;
  std::vector<std::string> plot = {"seconds", "triangles", "area", "volume"};
  std::string output;
};

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr size_t kMaxValues = 10'000;

template <class T>
double value_or_nan(const std::optional<T>& value) {
  return value ? static_cast<double>(*value) : kNaN;
}

/// A column of the table: its name, its label in plots and its value.
struct Column {
  const char* name;
  const char* label;
  int digits;  ///< Significant digits in the table.
  double (*value)(const metrics::Report&);
};

const std::vector<Column>& columns() {
  using R = metrics::Report;
  static const std::vector<Column> all = {
      {"seconds", "build time, s", 4, [](const R& r) { return value_or_nan(r.build_seconds); }},
      {"vertices", "vertices", 17, [](const R& r) { return static_cast<double>(r.vertices); }},
      {"triangles", "triangles", 17, [](const R& r) { return static_cast<double>(r.triangles); }},
      {"area", "surface, m²", 9, [](const R& r) { return r.area; }},
      {"volume", "volume, m³", 9, [](const R& r) { return r.volume; }},
      {"volume_cells", "volume of the cells inside, m³", 9,
       [](const R& r) { return value_or_nan(r.volume_cells); }},
      {"cf", "convex edges, %", 6, [](const R& r) { return value_or_nan(r.cf); }},
      {"cf_area", "convex edges by area, %", 6, [](const R& r) { return value_or_nan(r.cf_area); }},
      {"components", "pieces", 17, [](const R& r) { return static_cast<double>(r.components); }},
      {"genus", "handles", 17, [](const R& r) { return value_or_nan(r.genus); }},
      {"productions", "productions", 17, [](const R& r) { return value_or_nan(r.productions); }},
      {"length_x", "length along x, m", 6, [](const R& r) { return r.bounds.size().x; }},
      {"length_y", "length along y, m", 6, [](const R& r) { return r.bounds.size().y; }},
      {"length_z", "length along z, m", 6, [](const R& r) { return r.bounds.size().z; }},
  };
  return all;
}

const Column& column(const std::string& name) {
  std::vector<std::string> names;
  for (const Column& c : columns()) {
    if (c.name == name) return c;
    names.emplace_back(c.name);
  }
  throw Error(ErrorCode::bad_input, fmt::format("unknown column '{}'", name), {},
              suggestion(name, names));
}

template <class T>
bool parsed_number(const std::string& text, T& out) {
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), out);
  return code == std::errc() && end == text.data() + text.size();
}

/// Expands "1..100" to all integers from 1 to 100. Other values are kept as they are.
std::vector<std::string> expand_ranges(const std::vector<std::string>& values) {
  std::vector<std::string> out;
  for (const std::string& value : values) {
    const size_t dots = value.find("..");
    int64_t low = 0, high = 0;
    if (dots == std::string::npos || !parsed_number(value.substr(0, dots), low) ||
        !parsed_number(value.substr(dots + 2), high)) {
      out.push_back(value);
      continue;
    }
    if (low > high || high - low >= static_cast<int64_t>(kMaxValues))
      throw Error(ErrorCode::bad_input, fmt::format("invalid range '{}'", value), {},
                  fmt::format("write the smaller number first, and at most {} values", kMaxValues));
    for (int64_t v = low; v <= high; ++v) out.push_back(std::to_string(v));
  }
  return out;
}

struct SweepRow {
  std::string value;
  metrics::Report report;
};

/// The scene options with one value of the parameter.
SceneOptions scene_with(const SweepOptions& options, const std::string& value) {
  SceneOptions scene = options.scene;
  if (options.param == "seed") {
    uint64_t seed = 0;
    if (!parsed_number(value, seed))
      throw Error(ErrorCode::bad_input, fmt::format("invalid seed '{}'", value), {},
                  "a seed is an integer of at least 0");
    scene.seed = seed;
  } else {
    scene.defines.push_back(options.param + "=" + value);
  }
  return scene;
}

/// Loads the scene with each value of a parameter, so that an invalid value is reported before the
/// first measurement. ExitRequest or Error for the first one that is unusable.
void require_valid(const SweepOptions& options, const std::vector<std::string>& values) {
  for (const std::string& value : values) {
    const std::string doing = fmt::format("checking {} = {}", options.param, value);
    const SceneOptions scene = scene_with(options, value);
    if (options.param == "seed") continue;  // every seed is valid
    try {
      const loading::Loaded loaded = loading::load(scene.scene, scene.load_options());
      if (loaded.usable()) continue;
      fmt::print(stderr, "{}", loaded.report());
    } catch (Error& error) {
      throw error.within(doing);
    }
    fmt::print(stderr, "  while {}\n", doing);
    throw ExitRequest{kUnusable};
  }
}

SweepRow measure_value(const SweepOptions& options, const std::string& value) {
  const loading::Loaded loaded = scene_with(options, value).load();
  building::Builder builder(loaded.shot, options.work.build_options(loaded),
                            terminal_progress(options.work.bar_mode()));
  return {value, delivery::measure(builder)};
}

std::string table(const std::string& param, const std::vector<SweepRow>& rows) {
  std::string out = param;
  for (const Column& c : columns()) out += fmt::format(",{}", c.name);
  out += '\n';
  for (const SweepRow& row : rows) {
    out += row.value;
    for (const Column& c : columns()) {
      const double value = c.value(row.report);
      out += std::isnan(value) ? "," : fmt::format(",{:.{}g}", value, c.digits);
    }
    out += '\n';
  }
  return out;
}

/// Minimum, mean and maximum of each column.
std::string summary(const std::vector<SweepRow>& rows) {
  std::string out = fmt::format("{:<13} {:>11} {:>11} {:>11}\n", "", "min", "mean", "max");
  for (const Column& c : columns()) {
    double least = std::numeric_limits<double>::infinity(), most = -least, sum = 0;
    int count = 0;
    for (const SweepRow& row : rows) {
      const double value = c.value(row.report);
      if (std::isnan(value)) continue;
      least = std::min(least, value);
      most = std::max(most, value);
      sum += value;
      ++count;
    }
    if (count > 0)
      out +=
          fmt::format("{:<13} {:>11.6g} {:>11.6g} {:>11.6g}\n", c.name, least, sum / count, most);
  }
  return out;
}

std::string plot(const SweepOptions& options, const std::vector<SweepRow>& rows) {
  const std::string scene = std::filesystem::path(options.scene.scene).stem().string();
  Plot plot{scene + " against " + options.param, options.param, {}, {}, options.param != "seed"};
  for (size_t i = 0; i < rows.size(); ++i) {
    double x = 0;  // values that are not numbers, such as +X, are plotted at their index
    plot.x.push_back(parsed_number(rows[i].value, x) ? x : static_cast<double>(i + 1));
  }
  for (const std::string& name : options.plot) {
    const Column& c = column(name);
    Curve curve{c.label, {}};
    for (const SweepRow& row : rows) curve.y.push_back(c.value(row.report));
    plot.curves.push_back(std::move(curve));
  }
  return plot_svg(plot);
}

/// Measures the values until one fails. Returns the exit code; a failure has been reported.
int measure_all(const SweepOptions& options, const std::vector<std::string>& values,
                std::vector<SweepRow>& rows) {
  for (const std::string& value : values) {
    const std::string doing = fmt::format("measuring {} = {}", options.param, value);
    try {
      rows.push_back(measure_value(options, value));
    } catch (Error& error) {
      return print_error(error.within(doing));
    } catch (const ExitRequest& stop) {
      fmt::print(stderr, "  while {}\n", doing);
      return stop.exit;
    }
  }
  return kDone;
}

int run_sweep(const SweepOptions& options) {
  for (const std::string& name : options.plot) column(name);  // check names before any work
  if (options.param == "seed" && options.scene.seed)
    throw Error(ErrorCode::bad_input, "--seed conflicts with a sweep over the seed", {},
                "remove --seed");
  const std::string csv = options.output + ".csv", svg = options.output + ".svg";
  if (!options.output.empty()) require_outputs({csv, svg}, {options.scene.scene});
  const std::vector<std::string> values = expand_ranges(options.values);
  require_valid(options, values);
  std::vector<SweepRow> rows;
  const int exit = measure_all(options, values, rows);
  if (rows.empty()) return exit;
  if (exit != kDone)
    fmt::print(stderr, "the table contains the first {} of {} values\n", rows.size(),
               values.size());
  const std::string text = table(options.param, rows);
  fmt::print("{}", text);
  if (!options.work.quiet && rows.size() > 1) fmt::print(stderr, "{}", summary(rows));
  if (!options.output.empty()) {
    write_text(csv, text);
    write_text(svg, plot(options, rows));
  }
  return exit;
}

}  // namespace

Verb sweep_verb() {
  return {"sweep",
          "Measures a scene for several values of a parameter or several seeds; writes a table and "
          "plots.",
          [](CLI::App& app) {
            auto options = std::make_shared<SweepOptions>();
            options->scene.add_to(app, &options->work);
            app.add_option("--param,-p", options->param,
                           "Name of the parameter, e.g. LD; `seed` sweeps the scene's seed")
                ->required();
            app.add_option("--values,-v", options->values,
                           "Values of the parameter: 1,2,4,8 or 1..100")
                ->required()
                ->delimiter(',');
            app.add_option("--plot", options->plot,
                           "Columns to plot; default seconds,triangles,area,volume")
                ->delimiter(',');
            app.add_option("-o,--output", options->output,
                           "Stem of the output files OUTPUT.csv and OUTPUT.svg");
            options->work.add_to(app);
            return [options] {
              return with_threads(options->work.threads, [&] { return run_sweep(*options); });
            };
          }};
}

}  // namespace vug::cli
