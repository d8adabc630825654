// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/passages/curves/axis.h>
#include <vug/passages/passages.h>
#include <vug/passages/section_frames.h>
#include <vug/passages/sweep/sweep.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace vug::passages {
namespace {

constexpr double kArm = 4;       // Length of an arm in halves of the smaller size.
constexpr double kTrim = 0.5;    // A passage ends this part of its depth before another's axis.
constexpr double kSteepest = 2;  // Sections that change more per metre are not lofted.

/// A passage as segments, with the arc length from its start to the start of each segment.
struct SweptPassage {
  std::vector<Segment> segments;
  std::vector<double> along;
  double length = 0;
  double start_size = 1, end_size = 1;                // Smaller sizes at the ends.
  std::map<int, std::pair<double, double>> stations;  // Arc length and smaller size.
};

/// Shortens a passage at an end that lies inside another one.
void trim_start(Curve& curve) {
  double left = std::min(kTrim * 0.5 * curve.front().smaller(), 0.4 * arc_lengths(curve).back());
  while (curve.size() > 2) {
    const double length = (curve[1].position - curve[0].position).length();
    if (length > left) break;
    left -= length;
    curve.erase(curve.begin());
  }
  const double length = (curve[1].position - curve[0].position).length();
  CurvePoint start = between(curve[0], curve[1], std::min(left / length, 0.9));
  start.station = curve[0].station;
  start.measured = curve[0].measured;
  curve[0] = start;
}

Segment segment_between(const SectionFrame& a, const SectionFrame& b) {
  const Segment lofted(a, b);
  if (lofted.scale() * std::sqrt(1 + kSteepest * kSteepest) >= 1) return lofted;
  SectionFrame from = a, to = b;
  const bool first = a.section->traits().area > b.section->traits().area;
  (first ? to : from).section = first ? a.section : b.section;
  (first ? to : from).right = first ? a.right : b.right;
  (first ? to : from).up = first ? a.up : b.up;
  return Segment(from, to);
}

SweptPassage swept(Curve curve, const Chain& chain, const PassageOptions& options) {
  SweptPassage out;
  if (curve.size() < 2) return out;
  out.start_size = curve.front().smaller();
  out.end_size = curve.back().smaller();
  if (chain.start_meets) trim_start(curve);
  if (chain.end_meets) {
    std::reverse(curve.begin(), curve.end());
    trim_start(curve);
    std::reverse(curve.begin(), curve.end());
  }
  const std::vector<SectionFrame> sections = section_frames(curve, options);
  for (size_t i = 0; i < curve.size(); ++i) {
    if (curve[i].station >= 0 && curve[i].fixed)
      out.stations[curve[i].station] = {out.length, curve[i].smaller()};
    if (i + 1 == curve.size()) break;
    const double length = (curve[i + 1].position - curve[i].position).length();
    if (!(length > 0)) continue;
    out.segments.push_back(segment_between(sections[i], sections[i + 1]));
    out.along.push_back(out.length);
    out.length += length;
  }
  return out;
}

/// The segments of a passage within an arc length of a point of it.
Arm arm_around(const SweptPassage& passage, size_t first, double at, double reach) {
  Arm arm{passage.segments.size(), 0};
  for (size_t i = 0; i < passage.segments.size(); ++i) {
    const double start = passage.along[i];
    const double end = i + 1 < passage.along.size() ? passage.along[i + 1] : passage.length;
    if (end < at - reach || start > at + reach) continue;
    arm.first = std::min(arm.first, i);
    arm.last = std::max(arm.last, i + 1);
  }
  return {arm.first + first, arm.last + first};
}

bool disjoint(const Arm& a, const Arm& b) {
  return a.first < a.last && b.first < b.last && (a.last <= b.first || b.last <= a.first);
}

/// An arm at a station and the size of its passage there.
struct Meeting {
  size_t arm;
  double size;
};

}  // namespace

std::vector<SectionRule> default_rules() {
  const SectionFamilyPtr canyon = make_family("canyon");
  const double level = kPi / 3;
  return {{.family = canyon, .stage = network::Stage::vadose, .max_ratio = 1, .max_dip = level},
          {.family = canyon, .stage = network::Stage::unknown, .max_ratio = 0.5, .max_dip = level},
          {.family = make_family("lens"), .min_ratio = 2, .max_dip = level}};
}

void require_valid(const PassageOptions& o) {
  const auto refuse_option = [](const std::string& message, const std::string& hint) {
    throw Error(ErrorCode::bad_input, message, {}, hint);
  };
  for (const double size : {o.size.width, o.size.height, o.size.least})
    if (!(size > 0 && std::isfinite(size)))
      refuse_option(fmt::format("invalid size of passages {} m: must be above 0", size),
                    "give default widths and heights in metres");
  if (!(o.chamber >= 1 && o.chamber <= 10))
    refuse_option(fmt::format("invalid factor of chambers {}: must be 1 to 10", o.chamber),
                  "use 1 for junctions without chambers");
  if (!(o.fillet >= 0 && o.fillet <= 1))
    refuse_option(fmt::format("invalid fillet {}: must be 0 to 1", o.fillet),
                  "give the radius as a fraction of half the smaller size");
  if (!(o.bends.max_turn > 0.01 && o.bends.max_turn <= kPi) ||
      !(o.bends.max_bend > 0 && std::isfinite(o.bends.max_bend)))
    refuse_option(fmt::format("invalid bends with turns of {} radians and a curvature of {}",
                              o.bends.max_turn, o.bends.max_bend),
                  "use turns above 0.01 radians and a curvature above 0");
  if (!o.section) refuse_option("passages need a section", "name a section, e.g. tube");
}

field::Field passages(const network::Network& network, const PassageOptions& options) {
  require_valid(options);
  network::require_valid(network);
  const std::vector<Chain> all = chains(network);
  const std::vector<Curve> curves = axes(network, all, options);
  Sweep parts;
  std::map<int, std::vector<Meeting>> meetings;
  for (size_t i = 0; i < all.size(); ++i) {
    const SweptPassage passage = swept(curves[i], all[i], options);
    const size_t first = parts.segments.size();
    const auto meet = [&](int station, double at, double size) {
      meetings[station].push_back({parts.arms.size(), size});
      parts.arms.push_back(arm_around(passage, first, at, kArm * 0.5 * size));
    };
    if (all[i].start_meets) meet(all[i].stations.front(), 0, passage.start_size);
    if (all[i].end_meets) meet(all[i].stations.back(), passage.length, passage.end_size);
    for (size_t k = 1; k + 1 < all[i].stations.size(); ++k) {
      const auto at = passage.stations.find(all[i].stations[k]);
      if (at != passage.stations.end()) meet(at->first, at->second.first, at->second.second);
    }
    parts.segments.insert(parts.segments.end(), passage.segments.begin(), passage.segments.end());
  }
  if (options.fillet > 0)
    for (const auto& [station, here] : meetings)
      for (size_t a = 0; a < here.size(); ++a)
        for (size_t b = a + 1; b < here.size(); ++b)
          if (disjoint(parts.arms[here[a].arm], parts.arms[here[b].arm]))
            parts.joints.push_back({here[a].arm, here[b].arm,
                                    options.fillet * 0.5 * std::min(here[a].size, here[b].size)});
  return sweep(std::move(parts));
}

}  // namespace vug::passages
