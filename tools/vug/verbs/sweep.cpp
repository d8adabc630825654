#include "bar.h"
#include "load.h"
#include "plot.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/session/measure.h>

#include <cstdlib>

namespace vug::cli {
namespace {

struct Options {
  SceneOptions scene;
  WorkOptions work;
  std::string param;
  std::vector<std::string> values;
  std::string output;
};

struct Row {
  double value = 0;
  metrics::Report report;
};

Row measured(const Options& options, const std::string& value) {
  SceneOptions scene = options.scene;
  scene.defines.push_back(options.param + "=" + value);
  const session::Loaded loaded = scene.load();
  session::Builder builder(loaded.shot, {options.work.memory_limit()},
                           terminal_progress(options.work.quiet));
  Row row{std::strtod(value.c_str(), nullptr), session::measure(builder)};
  return row;
}

std::string table(const std::string& param, const std::vector<Row>& rows) {
  std::string out =
      param + ",seconds,vertices,triangles,area,volume,volume_cells,cf,cf_area,components,genus\n";
  for (const Row& row : rows) {
    const metrics::Report& r = row.report;
    out += fmt::format("{},{:.3f},{},{},{:.9g},{:.9g},{:.9g},{:.6g},{:.6g},{},{}\n", row.value,
                       r.build_seconds.value_or(0), r.vertices, r.triangles, r.area, r.volume,
                       r.volume_cells.value_or(0), r.cf.value_or(0), r.cf_area.value_or(0),
                       r.components, r.genus.value_or(0));
  }
  return out;
}

std::string plot(const std::string& title, const std::string& param, const std::vector<Row>& rows) {
  std::vector<double> x;
  std::vector<Curve> curves = {
      {"build time, s", {}}, {"triangles", {}}, {"surface, m²", {}}, {"volume, m³", {}}};
  for (const Row& row : rows) {
    x.push_back(row.value);
    curves[0].y.push_back(row.report.build_seconds.value_or(0));
    curves[1].y.push_back(static_cast<double>(row.report.triangles));
    curves[2].y.push_back(row.report.area);
    curves[3].y.push_back(row.report.volume);
  }
  return plot_svg(title, param, x, curves);
}

int run(const Options& options) {
  const ThreadLimit threads(options.work.threads);
  std::vector<Row> rows;
  for (const std::string& value : options.values) rows.push_back(measured(options, value));
  const std::string text = table(options.param, rows);
  fmt::print("{}", text);
  if (options.output.empty()) return kDone;
  write_text(options.output + ".csv", text);
  const std::string title =
      std::filesystem::path(options.scene.scene).stem().string() + " against " + options.param;
  write_text(options.output + ".svg", plot(title, options.param, rows));
  return kDone;
}

}  // namespace

Verb sweep_verb() {
  return {"sweep", "Measures a scene for several values of a parameter: a table and a plot.",
          [](CLI::App& app) {
            auto options = std::make_shared<Options>();
            options->scene.add_to(app);
            app.add_option("--param,-p", options->param, "the parameter, e.g. LD")->required();
            app.add_option("--values,-v", options->values, "its values: 1,2,4,8")
                ->required()
                ->delimiter(',');
            app.add_option("-o,--output", options->output, "writes OUTPUT.csv and OUTPUT.svg");
            options->work.add_to(app);
            return [options] { return run(*options); };
          }};
}

}  // namespace vug::cli
