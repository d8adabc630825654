// SPDX-License-Identifier: Apache-2.0
#include <vug/flora/profile.h>

#include <algorithm>

namespace vug::flora {
namespace {

/// Radius share of the narrow ring at an edge, which keeps its shading sharp.
constexpr double kEdge = 0.97;

/// Positions of the rings between two positions: those of the tube, those requested by the
/// displacement, and both ends.
std::vector<double> places(const Tube& tube, double from, double to, bool displacement) {
  std::vector<double> all = {from, to};
  for (const Ring& ring : tube.rings()) all.push_back(ring.along);
  if (displacement) {
    const std::vector<double> more = tube.displacement().rows();
    all.insert(all.end(), more.begin(), more.end());
  }
  std::sort(all.begin(), all.end());
  // Closer rings are merged.
  const double least = std::max(1e-7, 1e-3 * tube.rings().back().radius);
  std::vector<double> kept;
  for (const double s : all)
    if (s >= from && s <= to && (kept.empty() || s - kept.back() > least)) kept.push_back(s);
  kept.back() = to;
  return kept;
}

void add_inner(std::vector<ProfileRow>& rows, const Tube& tube, double from, double to,
               bool backwards) {
  std::vector<double> all = places(tube, from, to, false);
  if (backwards) std::reverse(all.begin(), all.end());
  for (const double s : all) rows.push_back({s, 1, true, false});
}

}  // namespace

std::vector<Profile> profiles(const Tube& tube) {
  std::vector<Profile> closed;
  const Chamber *at_start = nullptr, *at_end = nullptr;
  for (const Chamber& c : tube.chambers()) {
    if (c.from < tube.start()) at_start = &c;
    if (c.to > tube.end()) at_end = &c;
    if (c.from < tube.start() || c.to > tube.end()) continue;
    Profile inside;  // From the top down, so that the outside of the solid is the cavity.
    inside.rows.push_back({c.to, kEdge, true, false});
    add_inner(inside.rows, tube, c.from, c.to, true);
    inside.rows.push_back({c.from, kEdge, true, false});
    closed.push_back(std::move(inside));
  }
  Profile outer;
  outer.ring = at_start && at_start == at_end;
  if (at_start && !outer.ring) {  // Along the diaphragm, then down the wall.
    outer.rows.push_back({at_start->to, kEdge, true, false});
    add_inner(outer.rows, tube, tube.start(), at_start->to, true);
  }
  outer.rows.push_back({tube.start(), kEdge, false, true});
  for (const double s : places(tube, tube.start(), tube.end(), true))
    outer.rows.push_back({s, 1, false, false});
  outer.rows.push_back({tube.end(), kEdge, false, true});
  if (at_end) {
    const double to = outer.ring ? tube.start() : at_end->from;
    add_inner(outer.rows, tube, to, tube.end(), true);
    if (!outer.ring) outer.rows.push_back({to, kEdge, true, false});
  }
  closed.insert(closed.begin(), std::move(outer));
  return closed;
}

}  // namespace vug::flora
