// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/extended_elevation.h>

#include <vug/base/disjoint_sets.h>

#include <cmath>
#include <deque>
#include <optional>

namespace vug::survey {
namespace {

size_t index_of(int i) { return static_cast<size_t>(i); }

struct Unfolding {
  const Survey& survey;
  DisjointSets<int> points;
  std::vector<std::vector<int>> legs_of;  ///< By the root of a point.
  std::vector<int> shown;  ///< By the root of a point: its entrance, else its first station.
  std::vector<std::optional<double>> horizontal;  ///< By the root of a point, in metres.
  std::vector<bool> drawn;                        ///< By leg.
  std::vector<ElevationLeg> out;
  double right = 0;  ///< The right end of the drawing so far.

  explicit Unfolding(const Survey& all)
      : survey(all),
        points(all.stations.size()),
        legs_of(all.stations.size()),
        shown(all.stations.size(), -1),
        horizontal(all.stations.size()),
        drawn(all.legs.size(), false) {
    for (const Equate& each : survey.equates) points.join(each.a, each.b);
    for (size_t i = shown.size(); i-- > 0;) {
      const int root = points.root(static_cast<int>(i));
      int& name = shown[index_of(root)];
      if (name < 0 || survey.stations[i].entrance || !survey.stations[index_of(name)].entrance)
        name = static_cast<int>(i);
    }
    for (size_t i = 0; i < survey.legs.size(); ++i)
      if (!survey.legs[i].splay)
        for (const int end : {survey.legs[i].from, survey.legs[i].to})
          legs_of[index_of(points.root(end))].push_back(static_cast<int>(i));
  }

  const Vec3d& position(int point) const { return survey.stations[index_of(point)].position; }

  /// Draws a leg from a point that is in the drawing; returns its other end if that is new.
  std::optional<int> draw(int leg, int point) {
    if (drawn[index_of(leg)]) return std::nullopt;
    drawn[index_of(leg)] = true;
    const int from = points.root(survey.legs[index_of(leg)].from);
    const int to = points.root(survey.legs[index_of(leg)].to);
    const int next = from == point ? to : from;
    const Vec3d step = position(next) - position(point);
    const double here = *horizontal[index_of(point)];
    const double there = here + std::hypot(step.x, step.y);
    std::optional<double>& known = horizontal[index_of(next)];
    const bool cut = known && std::fabs(*known - there) > 1e-6;
    out.push_back({leg,
                   {Vec2d(here, position(point).z), Vec2d(there, position(next).z)},
                   {shown[index_of(point)], shown[index_of(next)]},
                   cut});
    right = std::max(right, there);
    if (known) return std::nullopt;
    known = there;
    return next;
  }

  /// Draws everything that is connected to a station and not yet in the drawing.
  void spread(int station) {
    const int start = points.root(station);
    if (horizontal[index_of(start)]) return;
    horizontal[index_of(start)] = out.empty() ? 0 : right + 10;
    std::deque<int> open = {start};
    while (!open.empty()) {
      const int point = open.front();
      open.pop_front();
      for (const int leg : legs_of[index_of(point)])
        if (const std::optional<int> next = draw(leg, point)) open.push_back(*next);
    }
  }
};

}  // namespace

std::vector<ElevationLeg> extend_elevation(const Survey& survey) {
  Unfolding unfolding(survey);
  for (const bool entrances : {true, false})
    for (size_t i = 0; i < survey.stations.size(); ++i)
      if (survey.stations[i].entrance || !entrances) unfolding.spread(static_cast<int>(i));
  return std::move(unfolding.out);
}

}  // namespace vug::survey
