// SPDX-License-Identifier: Apache-2.0
#include <vug/passages/curves/axis.h>
#include <vug/passages/curves/splay_section.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace vug::passages {
namespace {

using network::Network;

/// Stations at which a passage ends inside another one.
std::set<int> meeting_stations(const std::vector<Chain>& chains) {
  std::set<int> out;
  for (const Chain& chain : chains) {
    if (chain.start_meets) out.insert(chain.stations.front());
    if (chain.end_meets) out.insert(chain.stations.back());
  }
  return out;
}

/// The points of a chain at its stations, on the survey line.
Curve survey_line(const Network& network, const Chain& chain, const std::set<int>& meeting) {
  Curve curve;
  for (size_t i = 0; i < chain.stations.size(); ++i) {
    CurvePoint point;
    point.station = chain.stations[i];
    point.position = network.stations[static_cast<size_t>(point.station)].position;
    point.fixed = meeting.count(point.station) > 0;
    const size_t leg = std::min(i, chain.legs.size() - 1);
    point.stage = network.legs[static_cast<size_t>(chain.legs[leg])].stage;
    curve.push_back(point);
  }
  return curve;
}

/// The offset in the plane of a section from its origin to the middle of its bounding rectangle, or
/// to a point on the way that is well inside.
Vec2d towards_middle(const Section& section) {
  const SectionTraits& traits = section.traits();
  Vec2d offset = (traits.min + traits.max) * 0.5;
  for (int i = 0; i < 4; ++i) {
    if (section.distance(offset.x, offset.y) < -0.5 * traits.core) return offset;
    offset *= 0.5;
  }
  return {0, 0};
}

Curve axis_of(const Network& network, const Chain& chain, const std::set<int>& meeting,
              const PassageOptions& options) {
  Curve curve = survey_line(network, chain, meeting);
  std::vector<Vec3d> points;
  for (const CurvePoint& p : curve) points.push_back(p.position);
  const std::vector<Frame> across = frames(points, tangents(curve));
  const std::vector<Walls> walls = walls_along(network, chain, options.size);
  for (size_t i = 0; i < curve.size(); ++i) {
    CurvePoint& p = curve[i];
    const Walls& w = walls[i];
    const double widening = p.fixed && !w.measured && !chain.meets_at(i) ? options.chamber : 1;
    p.width = w.width() * widening;
    p.height = w.height() * widening;
    const auto& splays = network.stations[static_cast<size_t>(p.station)].splays;
    if (options.splays && !chain.meets_at(i))
      p.measured = splay_section(splays, p.position, across[i], w);
    if (p.measured) {
      p.width = p.measured->traits().width();
      p.height = p.measured->traits().height();
      const Vec2d offset = towards_middle(*p.measured);
      p.position += across[i].right * offset.x + across[i].up * offset.y;
    } else {
      p.position +=
          across[i].right * (0.5 * (w.right - w.left)) + across[i].up * (0.5 * (w.up - w.down));
    }
  }
  return curve;
}

Curve without_repetitions(const Curve& curve) {
  Curve out;
  for (const CurvePoint& p : curve)
    if (out.empty() || (p.position - out.back().position).length() > 1e-9) out.push_back(p);
  return out;
}

/// The walls of a station as seen from a point of the axis.
Walls walls_from(const Walls& walls, const Vec3d& offset, const Frame& frame) {
  const double u = offset.dot(frame.right), v = offset.dot(frame.up);
  return {walls.left + u, walls.right - u, walls.up - v, walls.down + v, walls.measured};
}

/// Measures the sections of splays about the final axis and across its final direction, so that the
/// walls stay where they are.
void remeasure(const Network& network, const Chain& chain, const DefaultSize& size, Curve& curve) {
  std::vector<Vec3d> points;
  for (const CurvePoint& p : curve) points.push_back(p.position);
  const std::vector<Frame> across = frames(points, tangents(curve));
  const std::vector<Walls> walls = walls_along(network, chain, size);
  for (size_t i = 0; i < curve.size(); ++i) {
    CurvePoint& p = curve[i];
    if (!p.measured || p.station < 0) continue;
    const auto at = std::find(chain.stations.begin(), chain.stations.end(), p.station);
    const network::Station& station = network.stations[static_cast<size_t>(p.station)];
    const Walls seen = walls_from(walls[static_cast<size_t>(at - chain.stations.begin())],
                                  p.position - station.position, across[i]);
    if (SectionPtr again = splay_section(station.splays, p.position, across[i], seen))
      p.measured = std::move(again);
  }
}

}  // namespace

std::vector<Curve> axes(const Network& network, const std::vector<Chain>& chains,
                        const PassageOptions& options) {
  const std::set<int> meeting = meeting_stations(chains);
  std::vector<Curve> out;
  std::map<int, Vec3d> joined;
  for (const Chain& chain : chains) {
    out.push_back(axis_of(network, chain, meeting, options));
    for (size_t i = 0; i < chain.stations.size(); ++i)
      if (!chain.meets_at(i)) joined.emplace(chain.stations[i], out.back()[i].position);
  }
  for (size_t k = 0; k < chains.size(); ++k) {
    Curve& curve = out[k];
    for (size_t i = 0; i < curve.size(); ++i)
      if (const auto at = joined.find(curve[i].station);
          chains[k].meets_at(i) && at != joined.end())
        curve[i].position = at->second;
    curve = without_repetitions(curve);
    if (curve.size() < 2) continue;
    if (options.smooth) curve = smoothed(curve, options.bends);
    curve = without_repetitions(meandered(curve, options.meanders));
    remeasure(network, chains[k], options.size, curve);
  }
  return out;
}

}  // namespace vug::passages
