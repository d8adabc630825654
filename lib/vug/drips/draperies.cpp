// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/drips/chemistry.h>
#include <vug/drips/draperies.h>
#include <vug/drips/surface.h>
#include <vug/field/path.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace vug::drips {
namespace {

/// Slopes in degrees between which draperies begin, are full, and end.
constexpr double kFirstSlope = 15, kFullSlope = 28, kSteepSlope = 62, kLastSlope = 76;
/// Shorter films have none; nearer ones share one.
constexpr double kShortest = 0.2, kApart = 0.13;
/// The share of the growth of a drip's tip by which the edge of its sheet grows, because the film
/// passes on; the widest, and the share of the height of the room (our choices).
constexpr double kEdgeShare = 0.75, kWidest = 1.4, kOfRoom = 0.5;
/// In thicknesses: the width from which on sheets hang freely; from the first width on, they come
/// out of the roof.
constexpr double kLeastWidth = 8, kFirstWidth = 4;
/// Roots are in the roof by this number of half thicknesses while nothing shows of a sheet, so that
/// their rounding is in the roof under slopes of up to 62 degrees.
constexpr double kRounding = 2.2;
constexpr double kEdge = 0.005, kRootThickness = 0.014;
constexpr double kLeastFold = 5;  // In distances of corners.
constexpr int kPlumbs = 5;

/// A film from its seep to the roof's end, or to a point of an earlier one.
struct Chain {
  const Node* seep = nullptr;
  std::vector<Vec3d> path{};
  double length = 0;
};

std::vector<Chain> chains_of(const Graph& graph) {
  std::map<int, const Edge*> out_of;
  std::set<int> reached;
  for (const Edge& edge : graph.edges) {
    if (edge.kind != EdgeKind::ceiling_film) continue;
    out_of[edge.from] = &edge;
    reached.insert(edge.to);
  }
  std::vector<Chain> chains;
  for (const auto& [node, first] : out_of) {
    if (reached.contains(node)) continue;
    Chain chain{&graph.nodes[static_cast<size_t>(node)], {first->path.front()}, 0};
    for (auto next = out_of.find(node); next != out_of.end();
         next = out_of.find(next->second->to)) {
      // Where films join, the first point of the other may lie a little higher.
      for (const Vec3d& p : next->second->path)
        if (p.y < chain.path.back().y) chain.path.push_back(p);
    }
    chain.length = field::path_length(chain.path);
    if (chain.length >= kShortest) chains.push_back(std::move(chain));
  }
  // The longest first, which others must keep away from.
  std::stable_sort(chains.begin(), chains.end(), [](const Chain& a, const Chain& b) {
    return a.length != b.length ? a.length > b.length : a.seep->id < b.seep->id;
  });
  return chains;
}

}  // namespace

double drapery_share(double slope) {
  const double degrees = slope * 180 / kPi;
  return std::clamp(std::min((degrees - kFirstSlope) / (kFullSlope - kFirstSlope),
                             (kLastSlope - degrees) / (kLastSlope - kSteepSlope)),
                    0.0, 1.0);
}

std::vector<HungDrapery> draperies_of(const field::Field& rock, const Graph& graph,
                                      const DraperyOptions& o) {
  std::vector<HungDrapery> out;
  std::vector<Vec3d> middles;
  for (Chain& chain : chains_of(graph)) {
    RandomStream random(RandomKey(o.seed).at("drapery").at(static_cast<uint64_t>(chain.seep->id)));
    const double rank = random.uniform(), folds = random.uniform(0.6, 1.5);
    const double fall = chain.path.front().y - chain.path.back().y;
    const double slope =
        maths::atan2(fall, std::sqrt(std::max(0.0, chain.length * chain.length - fall * fall)));
    if (!(rank < o.share * drapery_share(slope))) continue;
    const Vec3d middle = chain.path[chain.path.size() / 2];
    if (std::any_of(middles.begin(), middles.end(),
                    [&](const Vec3d& m) { return (m - middle).length() < kApart; }))
      continue;
    const Water& water = chain.seep->water;
    double widest = std::min(kWidest, 1.5 * chain.length);
    for (int i = 1; i <= kPlumbs; ++i) {
      const size_t at = (chain.path.size() - 1) * static_cast<size_t>(i) / kPlumbs;
      const Vec3d start = chain.path[at] - Vec3d(0, 0.03, 0);
      const auto below = VerticalLine(rock, start, 0.1).crossing(start.y, o.floor);
      const double room = rock.value(start) > 0 ? start.y - below.value_or(o.floor) : 0;
      widest = std::min(widest, kOfRoom * room);
    }
    // The tip is that of the voxels, which do not carry narrow folds.
    const double edge = std::max(kEdge, 2 * o.tip), finest = 2 * o.tip;
    if (widest < kLeastWidth * edge) continue;
    middles.push_back(middle);  // Whatever its age, so that neighbours do not depend on it.
    double width = kEdgeShare * water.age *
                   growth_rate(water.calcium, water.temperature, graph.interval(*chain.seep));
    width = std::min(width, widest);
    if (!(width > kFirstWidth * edge)) continue;
    const double thickness = std::max(kRootThickness, 1.5 * edge);
    const double part = std::min(1.0, (width / edge - kFirstWidth) / (kLeastWidth - kFirstWidth));
    if (part < 1) {
      width = part * kLeastWidth * edge;
      for (Vec3d& p : chain.path) p.y += kRounding * 0.5 * thickness * (1 - part);
    }
    out.push_back({chain.seep->id,
                   {.path = chain.path,
                    .width = width,
                    .edge = edge,
                    .root_thickness = thickness,
                    .fold = std::max(o.fold * folds, kLeastFold * finest),
                    .root = 0.02 + o.tip,
                    .finest = finest}});
  }
  std::sort(out.begin(), out.end(),
            [](const HungDrapery& a, const HungDrapery& b) { return a.drip < b.drip; });
  return out;
}

std::vector<field::Field> drapery_fields(const std::vector<HungDrapery>& draperies,
                                         const DraperyOptions& o) {
  std::vector<field::Field> fields(draperies.size());
  parallel_for(fields.size(), [&](size_t i) {
    const RandomKey key =
        RandomKey(o.seed).at("folds").at(static_cast<uint64_t>(draperies[i].drip));
    fields[i] = field::sheet_field("drapery", field::drapery_sheet(draperies[i].sheet, key));
  });
  return fields;
}

}  // namespace vug::drips
