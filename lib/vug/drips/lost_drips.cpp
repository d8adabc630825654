// SPDX-License-Identifier: Apache-2.0
#include <vug/drips/lost_drips.h>

#include <fmt/format.h>

#include <map>
#include <optional>

namespace vug::drips {
namespace {

/// The water has left the box if it ends within this distance of a face, in metres: the steps of
/// films are shorter.
constexpr double kAtFace = 0.06;

std::string position_text(const Vec3d& p) {
  return fmt::format("({:.2f}, {:.2f}, {:.2f})", p.x, p.y, p.z);
}

/// Where the water of a seep drips, ends, or reaches a floor.
struct Way {
  const Node* end = nullptr;
  double length = 0;  ///< Metres along the films.
  /// The drip whose water it has joined.
  std::optional<int64_t> joined{};
};

class Ways {
 public:
  explicit Ways(const Graph& graph) : graph_(graph) {
    for (size_t i = 0; i < graph.edges.size(); ++i) out_.emplace(graph.edges[i].from, i);
    for (size_t i = 0; i < graph.nodes.size(); ++i)
      if (graph.nodes[i].kind == NodeKind::seep)
        seeps_.emplace(graph.nodes[i].id, static_cast<int>(i));
  }

  /// Nothing for a drip that the graph does not have.
  std::optional<Way> of(int64_t drip) const {
    const auto seep = seeps_.find(drip);
    if (seep == seeps_.end()) return std::nullopt;
    Way way;
    for (int at = seep->second;;) {
      way.end = &graph_.nodes[static_cast<size_t>(at)];
      const auto next = out_.find(at);
      if (next == out_.end() || way.end->kind == NodeKind::drop) break;
      const Edge& edge = graph_.edges[next->second];
      if (edge.kind == EdgeKind::floor_film) break;
      for (size_t i = 1; i < edge.path.size(); ++i)
        way.length += (edge.path[i] - edge.path[i - 1]).length();
      at = edge.to;
    }
    if (way.end->kind == NodeKind::drop && way.end->id != drip) way.joined = way.end->id;
    return way;
  }

 private:
  const Graph& graph_;
  std::map<int, size_t> out_;     // From nodes to edges; films do not fork.
  std::map<int64_t, int> seeps_;  // From drips to nodes.
};

bool is_at_face(const Vec3d& p, const SeepOptions& o) {
  for (int axis = 0; axis < 3; ++axis)
    if (p[axis] < o.from[axis] + kAtFace || p[axis] > o.to[axis] - kAtFace) return true;
  return false;
}

std::string sink_reason(const Node& end, const SeepOptions& o) {
  if (is_at_face(end.position, o)) return "it leaves the box of the drips";
  return "neither a lower way nor a floor below was found";
}

LostDrip sunk_drip(const std::string& drip, const Way& way, const SourceLocation& where,
                   const SeepOptions& o) {
  return {
      where,
      fmt::format("{} does not drip: its water ends in a sink at {}, {:.0f} cm from where it "
                  "leaves the roof, because {}",
                  drip, position_text(way.end->position), 100 * way.length,
                  sink_reason(*way.end, o)),
      is_at_face(way.end->position, o)
          ? "extend the box of the drips, or choose a point farther inside"
          : "extend the box down to the floor, or choose a point some decimetres away; under rough "
            "roofs and in narrow clefts, films lose their way"};
}

LostDrip joined_drip(const std::string& drip, const Way& way, const SourceLocation& where) {
  return {where,
          fmt::format("{} has no place of its own: its water joins that of drip {}, and both drip "
                      "at {}",
                      drip, *way.joined, position_text(way.end->position)),
          "choose a point farther from the other drip, or remove one of them"};
}

}  // namespace

std::vector<LostDrip> lost_drips(const Graph& graph, const GraphOptions& options) {
  const Ways ways(graph);
  std::vector<LostDrip> lost;
  const auto examine = [&](int64_t drip, const char* verb, const SourceLocation& where) {
    const std::optional<Way> way = ways.of(drip);
    if (!way) return;
    const std::string name = fmt::format("the {} drip {}", verb, drip);
    if (way->end->kind == NodeKind::sink) lost.push_back(sunk_drip(name, *way, where, options));
    if (way->joined) lost.push_back(joined_drip(name, *way, where));
  };
  for (const DripEdits::Move& each : options.edits.moved) examine(each.drip, "moved", each.where);
  for (size_t i = 0; i < options.edits.added.size(); ++i)
    examine(-1 - static_cast<int64_t>(i), "added", options.edits.added[i].where);
  return lost;
}

}  // namespace vug::drips
