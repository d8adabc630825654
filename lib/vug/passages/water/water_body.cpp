// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/field/boolean.h>
#include <vug/field/modifier.h>
#include <vug/passages/water/body_builder.h>
#include <vug/passages/water/fall.h>
#include <vug/passages/water/water_body.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

constexpr double kShortPool = 1.5;    // Metres.
constexpr double kLeastFall = 0.5;    // Metres; lower steps are parts of riffles.
constexpr double kGroundSpacing = 1;  // Metres between points of sediment and ponds.

/// The passages grown by a distance.
struct Grown {
  double distance;
  template <class T>
  T apply(const T& value, const field::Point<T>&) const {
    return value - T(distance);
  }
  field::Traits traits(const field::Traits& child) const {
    field::Traits out = child;
    out.bounds = child.bounds_below(distance);
    out.growth = child.growth_rate();
    out.exactness = std::max(child.exactness, field::Exactness::bound);
    return out;
  }
  Interval range(Interval child) const { return child - Interval(distance); }
};

field::Field within_passages(const network::Network& network, const PassageOptions& options,
                             field::Field body, double overlap) {
  const field::Field air = passages(network, options);
  return field::intersect(
      {std::move(body), field::Field(std::make_shared<field::ModifierNode<Grown>>(
                            "grown", Grown{overlap}, air.node()))});
}

void require_overlap(double overlap) {
  if (!(overlap >= 0.05 && overlap <= 100))
    throw Error(ErrorCode::bad_input,
                fmt::format("invalid overlap of {} m: must be 0.05 to 100 m", overlap), {},
                "use more than the depth of the relief on the walls");
}

/// For each edge of a line, whether water leaves the bed between its points. Level pieces that are
/// shorter than kShortPool and lie between two falls belong to one fall.
std::vector<char> falling_edges(const Stream& stream, const FloorLine& line, double steepness) {
  std::vector<char> out(line.size(), 0);
  const auto level = [&](size_t i) { return stream.level[static_cast<size_t>(line[i].node)]; };
  double short_length = 0;
  size_t after_fall = line.size();  // The first edge after the last fall.
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    const double length = plan_distance(stream.plan, line[i].node, line[i + 1].node);
    if (!stream.wet(line[i].node) || !stream.wet(line[i + 1].node)) {
      after_fall = line.size();
      continue;
    }
    const double drop = level(i) - level(i + 1);
    out[i] = drop != 0 && std::fabs(drop) * maths::cos(steepness) >= length * maths::sin(steepness);
    if (!out[i]) {
      short_length += length;
      continue;
    }
    if (after_fall < i && short_length < kShortPool &&
        (level(after_fall - 1) > level(after_fall)) == (drop > 0))
      std::fill(out.begin() + static_cast<long>(after_fall), out.begin() + static_cast<long>(i), 1);
    after_fall = i + 1;
    short_length = 0;
  }
  return out;
}

/// Appends the fall over the edges [first, last) of a line.
void append_fall(const Stream& stream, const FloorLine& line, size_t first, size_t last,
                 double thickness, std::vector<Polytope>& out) {
  const auto level = [&](size_t i) { return stream.level[static_cast<size_t>(line[i].node)]; };
  const bool forwards = level(first) > level(last);
  const size_t lip = forwards ? first : last, foot = forwards ? last : first;
  Fall fall;
  fall.foot = level(foot);
  fall.thickness = thickness;
  double farthest = 0;
  const auto append = [&](size_t i) {
    const FloorNode& node = stream.plan.nodes[static_cast<size_t>(line[i].node)];
    const Vec3d right = forwards ? line[i].right : -line[i].right;
    FallPoint point{{node.position.x, level(i), node.position.z}, right};
    if (!fall.way.empty()) {
      // Rock that retreats below an overhang does not lead the water back.
      const FallPoint& start = fall.way.front();
      const Vec3d forward = Vec3d(0, 1, 0).cross(start.right);
      const double advance = forward.dot(point.position - start.position);
      if (advance <= farthest) {
        point.position.x = fall.way.back().position.x;
        point.position.z = fall.way.back().position.z;
      }
      farthest = std::max(farthest, advance);
    }
    fall.way.push_back(point);
  };
  for (size_t i = lip;; i = forwards ? i + 1 : i - 1) {
    append(i);
    if (i == foot) break;
  }
  // Water that slides lies on the bed with its whole thickness.
  const std::vector<FallPoint> bed = fall.way;
  for (size_t i = 1; i + 1 < bed.size(); ++i) {
    const Vec3d step = bed[i + 1].position - bed[i - 1].position;
    const double level_step = std::max(in_plan(step).length(), 1e-6), slope = step.y / level_step;
    const double raise = std::min(std::sqrt(1 + slope * slope), 10.0) * thickness;
    fall.way[i].position.y = std::min(bed[i].position.y + raise, bed[0].position.y);
  }
  const auto node = static_cast<size_t>(line[lip].node);
  fall.discharge = std::max(stream.discharge[node], 1e-3);
  fall.width = std::clamp(stream.width[node], 0.2, 0.8 * stream.plan.nodes[node].width);
  append_fall(fall, out);
}

/// Marks falls that are high enough, and appends them.
std::vector<char> append_falls(const Stream& stream, const FloorLine& line, double steepness,
                               double thickness, std::vector<Polytope>& out) {
  std::vector<char> edges = falling_edges(stream, line, steepness);
  const auto level = [&](size_t i) { return stream.level[static_cast<size_t>(line[i].node)]; };
  for (size_t first = 0; first < edges.size(); ++first) {
    if (!edges[first]) continue;
    size_t last = first;
    const bool down = level(first + 1) < level(first);
    while (last < edges.size() && edges[last] &&
           (down ? level(last + 1) <= level(last) : level(last + 1) >= level(last)))
      ++last;
    if (std::fabs(level(first) - level(last)) >= kLeastFall)
      append_fall(stream, line, first, last, thickness, out);
    else
      std::fill(edges.begin() + static_cast<long>(first), edges.begin() + static_cast<long>(last),
                0);
    first = last - 1;
  }
  return edges;
}

}  // namespace

field::Field stream_body(const network::Network& network, const PassageOptions& options,
                         const StreamOptions& water, const StreamBodyOptions& form) {
  require_overlap(form.overlap);
  const Stream surface = stream(network, options, water);
  BodyBuilder body(surface.plan, surface.level, form.overlap);
  std::vector<Polytope> falls;
  for (const FloorLine& line : surface.plan.lines)
    body.append(line, append_falls(surface, line, water.fall, form.thickness, falls));
  std::vector<Polytope> parts;
  if (form.part != StreamPart::falls) parts = std::move(body.parts);
  if (form.part != StreamPart::surface) parts.insert(parts.end(), falls.begin(), falls.end());
  if (parts.empty()) return field::empty();
  return within_passages(network, options, polytopes("stream", std::move(parts)), form.overlap);
}

field::Field sediment_body(const network::Network& network, const PassageOptions& options,
                           const SedimentOptions& sediment, double overlap) {
  require_overlap(overlap);
  const FloorPlan plan = floor_plan(network, options, kGroundSpacing);
  std::vector<double> top = sediment_heights(plan, sediment);
  for (size_t i = 0; i < top.size(); ++i)
    if (!(top[i] > plan.nodes[i].floor)) top[i] = -kInfinity;
  BodyBuilder body(plan, top, overlap);
  for (const FloorLine& line : plan.lines) body.append(line, std::vector<char>(line.size(), 0));
  return within_passages(network, options, polytopes("sediment", std::move(body.parts)), overlap);
}

std::vector<double> pond_levels(const FloorPlan& plan, const std::vector<double>& bed,
                                const std::vector<int>& outlets, double depth) {
  const Flood basins = flood(plan, bed, outlets);
  const std::vector<std::vector<int>> adjacent = neighbours(plan);
  std::vector<double> out(bed.size(), -kInfinity);
  std::vector<char> visited(bed.size(), 0);
  const auto flooded = [&](size_t i) { return basins.level[i] > bed[i]; };
  for (size_t start = 0; start < bed.size(); ++start) {
    if (visited[start] || !flooded(start)) continue;
    // Neighbours under water have one level, because water between them can pass both ways.
    std::vector<int> basin{static_cast<int>(start)};
    visited[start] = 1;
    double lowest = bed[start];
    for (size_t k = 0; k < basin.size(); ++k)
      for (const int next : adjacent[static_cast<size_t>(basin[k])]) {
        const auto i = static_cast<size_t>(next);
        if (visited[i] || !flooded(i)) continue;
        visited[i] = 1;
        lowest = std::min(lowest, bed[i]);
        basin.push_back(next);
      }
    const double level = std::min(basins.level[start], lowest + depth);
    for (const int node : basin)
      if (bed[static_cast<size_t>(node)] < level) out[static_cast<size_t>(node)] = level;
  }
  return out;
}

field::Field pond_body(const network::Network& network, const PassageOptions& options,
                       const SedimentOptions& bed, const std::vector<int>& outlets, double depth,
                       double overlap) {
  require_overlap(overlap);
  const FloorPlan plan = floor_plan(network, options, kGroundSpacing);
  const std::vector<double> top = pond_levels(
      plan, sediment_heights(plan, bed),
      outlets.empty() ? default_outlets(plan, network) : nodes_at(plan, network, outlets), depth);
  BodyBuilder body(plan, top, overlap);
  for (const FloorLine& line : plan.lines) body.append(line, std::vector<char>(line.size(), 0));
  return within_passages(network, options, polytopes("ponds", std::move(body.parts)), overlap);
}

}  // namespace vug::passages
