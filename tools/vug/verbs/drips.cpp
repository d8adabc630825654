// SPDX-License-Identifier: Apache-2.0
#include "scene_options.h"

#include <vug/base/memory.h>
#include <vug/base/parallel.h>
#include <vug/delivery/drip_points.h>
#include <vug/drips/growth_report.h>
#include <vug/drips/inventory.h>
#include <vug/drips/lost_drips.h>
#include <vug/picture/frame_sequence.h>
#include <vug/shot/drips_plan.h>
#include <vug/shot/queries.h>
#include <vug/volume/io.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <filesystem>
#include <optional>

namespace vug::cli {
namespace {

using Json = nlohmann::ordered_json;

struct DripsOptions {
  SceneOptions scene;
  WorkOptions work;
  std::string name;
  std::string points;
  std::string frames;
  bool json = false;
};

Json json_of(const Vec3d& p) { return Json::array({p.x, p.y, p.z}); }

Json json_of(const drips::Node& node) {
  Json out{{"kind", drips::kind_name(node.kind)},   {"drip", node.id},
           {"position", json_of(node.position)},    {"normal", json_of(node.normal)},
           {"discharge", node.water.discharge},     {"calcium", node.water.calcium},
           {"temperature", node.water.temperature}, {"age", node.water.age}};
  if (node.kind == drips::NodeKind::pool) out["level"] = node.level;
  return out;
}

/// The name of Speleothem::size for a kind.
std::string size_name(const std::string& kind) {
  return kind == "drapery" ? "width" : kind == "flowstone" ? "thickness" : "radius";
}

Json json_of(const drips::Speleothem& s, const drips::Graph& graph) {
  Json out{{"kind", s.kind},         {"drip", s.drip},
           {"top", json_of(s.top)},  {"bottom", json_of(s.bottom)},
           {"length", s.length},     {size_name(s.kind), s.size},
           {"interval", s.interval}, {"age", s.age}};
  if (s.since > 0) out["since"] = s.since;
  if (s.plane >= 0) out["plane"] = graph.planes[static_cast<size_t>(s.plane)];
  return out;
}

Json json_of(const drips::Graph& graph, const std::vector<drips::Speleothem>& forms) {
  Json nodes = Json::array(), edges = Json::array(), grown = Json::array();
  for (const drips::Node& node : graph.nodes) nodes.push_back(json_of(node));
  for (const drips::Edge& edge : graph.edges) {
    Json path = Json::array();
    for (const Vec3d& p : edge.path) path.push_back(json_of(p));
    edges.push_back({{"kind", drips::kind_name(edge.kind)},
                     {"from", edge.from},
                     {"to", edge.to},
                     {"discharge", edge.water.discharge},
                     {"calcium", edge.water.calcium},
                     {"path", std::move(path)}});
  }
  for (const drips::Speleothem& form : forms) grown.push_back(json_of(form, graph));
  return {{"nodes", std::move(nodes)}, {"edges", std::move(edges)}, {"forms", std::move(grown)}};
}

void print_text(const drips::Graph& graph, const std::vector<drips::Speleothem>& forms) {
  std::array<size_t, 7> counts{};
  for (const drips::Node& node : graph.nodes) ++counts[static_cast<size_t>(node.kind)];
  const auto count = [&](drips::NodeKind kind) { return counts[static_cast<size_t>(kind)]; };
  fmt::print("{} seeps, {} drops, {} landings, {} pools; {} speleothems\n",
             count(drips::NodeKind::seep), count(drips::NodeKind::drop),
             count(drips::NodeKind::landing), count(drips::NodeKind::pool), forms.size());
  for (size_t i = 0; i < forms.size(); ++i) fmt::print("{}\n", drips::explain(forms[i], i, graph));
}

/// The edge of the voxels of a grid of that many points in a box.
double voxel_for(const volume::Points& points) {
  Box3d box;
  for (const Vec3f& p : points.position) box.extendBy(Vec3d(p));
  const Vec3d size = box.size();
  const double area = size.x * size.z + size.y * (size.x + size.z);
  return volume::voxel_for_points(area / static_cast<double>(points.size()));
}

void write_points(const std::filesystem::path& target, const volume::Points& points) {
  if (target.extension() != ".vdb")
    throw Error(ErrorCode::bad_input,
                fmt::format("'{}': the points of drips are written as .vdb", target.string()), {},
                "use a name that ends with .vdb");
  if (points.size() == 0)
    throw Error(ErrorCode::bad_input, "the graph of the drips is empty, so it has no points", {},
                "increase the density, or check the box");
  volume::write(target, {volume::point_grid(points, voxel_for(points)).named("drips")});
}

/// The drips of a loaded scene. Error(too_large) if their graph needs more memory than allowed.
const shot::DripsPlan& plan_of(const loading::Loaded& loaded, const DripsOptions& options) {
  const shot::DripsPlan& plan = *shot::find_drips(loaded.shot, options.name).drips;
  require_memory(drips::graph_memory(plan.options().graph), options.work.memory_limit(),
                 "the graph of the drips", "use a larger spacing or a smaller box");
  return plan;
}

std::string event_line(const drips::GrowthEvent& event) {
  if (event.kind.empty()) return "none";
  return fmt::format("{:.2g} cm, {} of drip {} at frame {}", 100 * event.size, event.kind,
                     event.drip, event.frame);
}

void print_list(const char* title, const std::vector<drips::GrowthEvent>& events) {
  fmt::print("{}: {}\n", title, events.size());
  for (const drips::GrowthEvent& event : events) fmt::print("  {}\n", event_line(event));
}

/// Warns about drips that are added or moved by hand and do not drip; false if warnings are errors.
bool report_lost(const loading::Loaded& loaded, const DripsOptions& options,
                 const std::vector<drips::LostDrip>& lost) {
  Diagnostics diagnostics;
  for (const drips::LostDrip& each : lost) diagnostics.warning(each.where, each.message, each.hint);
  options.scene.apply_strictness(diagnostics);
  fmt::print(stderr, "{}", loaded.report(diagnostics));
  return !diagnostics.has_errors();
}

/// Refuses frames whose age is less than that of the frame before.
class AgeCheck {
 public:
  void add(int frame, double age) {
    if (age < age_)
      throw Error(ErrorCode::bad_input,
                  fmt::format("the age of the drips decreases from {:g} years at frame {} to {:g} "
                              "at frame {}, but speleothems only grow",
                              age_, frame_, age, frame),
                  {},
                  "give 'age' keys that increase with the frame, and name frames in ascending "
                  "order");
    frame_ = frame, age_ = age;
  }

 private:
  int frame_ = 0;
  double age_ = 0;
};

/// Compares the speleothems of the frames of a sequence.
int run_frames(const DripsOptions& options) {
  const loading::SceneSource source = options.scene.source();
  drips::GrowthCheck check;
  AgeCheck ages;
  std::optional<Digest> first;
  bool same = true;
  for (const int frame : picture::parse_frames(options.frames)) {
    const loading::Loaded loaded = options.scene.load(source, frame);
    const shot::DripsPlan& plan = plan_of(loaded, options);
    ages.add(frame, plan.options().graph.oldest);
    const Digest digest = plan.digest();
    same = same && digest == first.value_or(digest);
    first = first.value_or(digest);
    check.add(frame, plan.grown(), plan.options().forms);
  }
  const drips::GrowthReport& report = check.report();
  if (same && report.frames > 1) {
    fmt::print(
        "the {} parts of speleothems are the same in all {} frames, because nothing that they "
        "depend on has keys; 'age: keys(1: 200, 240: 30000), final_age: 30000' lets them grow\n",
        report.speleothems, report.frames);
    return kDone;
  }
  fmt::print("{} frames, {} parts of speleothems at the end\n", report.frames, report.speleothems);
  fmt::print("greatest size at its first frame: {}\n", event_line(report.first));
  fmt::print("greatest step between two frames: {}\n", event_line(report.step));
  print_list("stalactites that break", report.broken);
  print_list("speleothems that disappear", report.lost);
  return report.lost.empty() ? kDone : kAnswerNo;
}

int run_drips(const DripsOptions& options) {
  const loading::Loaded loaded = options.scene.load();
  const shot::DripsPlan& plan = plan_of(loaded, options);
  const drips::Graph& graph = plan.graph();
  if (!report_lost(loaded, options, drips::lost_drips(graph, plan.options().graph)))
    return kUnusable;
  const std::vector<drips::Speleothem> grown = drips::inventory(plan.grown(), graph);
  if (!options.points.empty()) write_points(options.points, delivery::drip_points(graph));
  if (options.json)
    fmt::print("{}\n", json_of(graph, grown).dump(2));
  else
    print_text(graph, grown);
  return kDone;
}

}  // namespace

Verb drips_verb() {
  return {"drips", "Prints the drips of a scene and the speleothems that grow from them.",
          [](CLI::App& app) {
            auto options = std::make_shared<DripsOptions>();
            options->scene.add_to(app, &options->work);
            options->work.add_to(app);
            app.add_option("--drips", options->name, "Name of the drips; default the first");
            app.add_option("--points", options->points,
                           "Also writes the graph as points to this .vdb file");
            app.add_flag("--json", options->json,
                         "The whole graph with its paths, and the speleothems, as JSON");
            app.add_option("--frames", options->frames,
                           "Compare the speleothems of these frames, e.g. 1..240: sizes at the "
                           "first frame, steps, and breaks. Exit code 1 if one disappears")
                ->excludes("--json")
                ->excludes("--points");
            return [options] {
              return with_threads(options->work.threads, [&] {
                return options->frames.empty() ? run_drips(*options) : run_frames(*options);
              });
            };
          }};
}

}  // namespace vug::cli
