// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/base/rng.h>
#include <vug/passages/water/stream.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

constexpr double kLacey = 4.83;  // Width by the square root of the discharge, s^0.5 / m^0.5.
constexpr double kLeastSlope = 1e-3;
constexpr double kCrest = 0.6;  // A riffle rises by this part of the fall from one to the next.
constexpr double kHighestCrest = 0.3;  // Metres.
constexpr double kShare = 0.25;  // Of a source's discharge, in a passage into which water spills.
constexpr double kDry = 1e-3;    // Metres of water that do not spill.

void require_stream_options(const StreamOptions& o) {
  const auto refuse_option = [](const std::string& message, const std::string& hint) {
    throw Error(ErrorCode::bad_input, message, {}, hint);
  };
  if (!(o.discharge > 0 && o.discharge <= 1000))
    refuse_option(
        fmt::format("invalid discharge of {} m^3/s: must be above 0 and at most 1000", o.discharge),
        "a small stream has 0.05 m^3/s");
  if (!(o.roughness >= 0.01 && o.roughness <= 0.5))
    refuse_option(fmt::format("invalid roughness {}: must be 0.01 to 0.5", o.roughness),
                  "give Manning's n, which is 0.05 for a bed of cobbles");
  if (!(o.fall > 0.1 && o.fall <= kPi / 2) || !(o.spacing >= 0.05 && o.spacing <= 100))
    refuse_option(fmt::format("invalid stream with falls from {} radians and a spacing of {} m",
                              o.fall, o.spacing),
                  "use falls from 0.1 radians and a spacing of 0.05 to 100 m");
}

/// Computes the members of a stream step by step.
class Solver {
 public:
  Solver(FloorPlan plan, const StreamOptions& options) : options_(options) {
    out_.plan = std::move(plan);
    out_.bed = sediment_heights(out_.plan, options.sediment);
  }

  Stream run(const std::vector<int>& sources, const std::vector<int>& outlets) {
    flood_ = flood(out_.plan, out_.bed, outlets);
    out_.towards = flood_.towards;
    const size_t count = out_.plan.nodes.size();
    sources_.assign(count, 0);
    for (const int source : sources) sources_[static_cast<size_t>(source)] = options_.discharge;
    const std::vector<std::vector<int>> adjacent = neighbours(out_.plan);
    // Water that rises above the floor of a passage that leads elsewhere runs into it as well.
    do {
      accumulate();
      set_sizes();
      set_levels();
    } while (spill(adjacent));
    return std::move(out_);
  }

 private:
  static size_t at(int node) { return static_cast<size_t>(node); }

  void accumulate() {
    out_.discharge = sources_;
    for (auto node = flood_.order.rbegin(); node != flood_.order.rend(); ++node)
      if (const int next = out_.towards[at(*node)]; next >= 0)
        out_.discharge[at(next)] += out_.discharge[at(*node)];
  }

  /// The slope of the flooded ground from a node to one that is `reach` metres downstream.
  double slope(int node, double reach) const {
    double distance = 0;
    int end = node;
    while (distance < reach && out_.towards[at(end)] >= 0) {
      distance += plan_distance(out_.plan, end, out_.towards[at(end)]);
      end = out_.towards[at(end)];
    }
    const double drop = flood_.level[at(node)] - flood_.level[at(end)];
    return distance > 0 ? std::clamp(drop / distance, kLeastSlope, 1.0) : kLeastSlope;
  }

  /// Whether the bed is steep enough for a fall or a slide, on which no riffle forms.
  bool falls(int node, int next) const {
    const double drop = out_.bed[at(node)] - out_.bed[at(next)];
    return drop * maths::cos(options_.fall) >=
           plan_distance(out_.plan, node, next) * maths::sin(options_.fall);
  }

  void set_sizes() {
    const size_t count = out_.plan.nodes.size();
    out_.width.assign(count, 0);
    depth_.assign(count, 0);
    crest_.assign(count, 0);
    std::vector<double> to_riffle(count, 0);
    for (const int node : flood_.order) {
      const size_t i = at(node);
      const double flow = out_.discharge[i];
      if (!(flow > 0)) continue;
      const double width = std::min(kLacey * std::sqrt(flow), 0.9 * out_.plan.nodes[i].width);
      const double steepness = slope(node, 6 * width);
      out_.width[i] = width;
      depth_[i] = maths::pow(options_.roughness * flow / (width * std::sqrt(steepness)), 0.6);
      const int next = out_.towards[i];
      if (next < 0) continue;
      to_riffle[i] = to_riffle[at(next)] - plan_distance(out_.plan, node, next);
      if (to_riffle[i] > 0 || falls(node, next)) continue;
      RandomStream random(RandomKey(options_.seed).at("riffles").at(i));
      const double steep = std::clamp((steepness - 0.02) / 0.03, 0.0, 1.0);
      to_riffle[i] = width * (6 - 3.5 * steep) * random.uniform(0.7, 1.3);
      crest_[i] = std::min({kCrest * steepness * to_riffle[i], kHighestCrest, 0.5 * width});
    }
  }

  void set_levels() {
    const size_t count = out_.plan.nodes.size();
    out_.level.assign(count, -kInfinity);
    out_.pool.assign(count, -1);
    int pools = 0;
    for (const int node : flood_.order) {
      const size_t i = at(node);
      const int next = out_.towards[i];
      const double below = next >= 0 ? out_.level[at(next)] : -kInfinity;
      const bool flows = out_.discharge[i] > 0;
      if (!flows && !(out_.bed[i] < below)) continue;
      const double level = flows ? out_.bed[i] + depth_[i] + crest_[i] : below;
      out_.level[i] = std::max(level, below);
      out_.pool[i] = out_.level[i] > below ? pools++ : out_.pool[at(next)];
    }
  }

  bool spill(const std::vector<std::vector<int>>& adjacent) {
    bool more = false;
    for (size_t i = 0; i < adjacent.size(); ++i)
      for (const int next : adjacent[i]) {
        if (out_.wet(next) || !(out_.bed[at(next)] < out_.level[i] - kDry)) continue;
        if (sources_[at(next)] > 0) continue;
        sources_[at(next)] = kShare * options_.discharge;
        more = true;
      }
    return more;
  }

  const StreamOptions& options_;
  Stream out_;
  Flood flood_;
  std::vector<double> sources_, depth_, crest_;
};

}  // namespace

std::vector<double> sediment_heights(const FloorPlan& plan, const SedimentOptions& options) {
  constexpr double kTaper = 10 * kPi / 180;
  std::vector<double> steepest(plan.nodes.size(), 0);
  for (const FloorLine& line : plan.lines)
    for (size_t i = 0; i + 1 < line.size(); ++i) {
      const auto a = static_cast<size_t>(line[i].node), b = static_cast<size_t>(line[i + 1].node);
      const double rise = std::fabs(plan.nodes[a].floor - plan.nodes[b].floor);
      const double dip = maths::atan2(rise, plan_distance(plan, line[i].node, line[i + 1].node));
      steepest[a] = std::max(steepest[a], dip);
      steepest[b] = std::max(steepest[b], dip);
    }
  std::vector<double> out;
  for (size_t i = 0; i < plan.nodes.size(); ++i) {
    const FloorNode& node = plan.nodes[i];
    const double share = std::clamp((options.repose - steepest[i]) / kTaper, 0.0, 1.0);
    out.push_back(node.floor + share * (options.depth + options.fill * (node.roof - node.floor)));
  }
  return out;
}

Stream stream(const network::Network& network, const PassageOptions& passages,
              const StreamOptions& options) {
  require_stream_options(options);
  FloorPlan plan = floor_plan(network, passages, options.spacing);
  const std::vector<int> from =
      options.from.empty() ? default_sources(plan, network) : nodes_at(plan, network, options.from);
  const std::vector<int> to =
      options.to.empty() ? default_outlets(plan, network) : nodes_at(plan, network, options.to);
  return Solver(std::move(plan), options).run(from, to);
}

}  // namespace vug::passages
