// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/passages/curves/axis.h>
#include <vug/passages/section_frames.h>
#include <vug/passages/water/floor_plan.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace vug::passages {
namespace {

constexpr double kMostPoints = 5e5;
// Passages whose tangent has a smaller horizontal part keep the direction of their frame.
constexpr double kLevel = 0.3;

/// The section at a point of an axis, reduced to numbers that can be interpolated.
struct Profile {
  FloorNode node;
  FloorPoint point;
};

Profile mixed(const Profile& a, const Profile& b, double t) {
  const auto mix = [t](auto x, auto y) { return x + (y - x) * t; };
  Profile out;
  out.node = {.position = mix(a.node.position, b.node.position),
              .floor = mix(a.node.floor, b.node.floor),
              .roof = mix(a.node.roof, b.node.roof),
              .width = mix(a.node.width, b.node.width)};
  const Vec3d right = mix(a.point.right, b.point.right);
  out.point = {.node = 0,
               .right = right.length() > 1e-6 ? right.normalized() : a.point.right,
               .left_wall = mix(a.point.left_wall, b.point.left_wall),
               .right_wall = mix(a.point.right_wall, b.point.right_wall),
               .reach = mix(a.point.reach, b.point.reach)};
  return out;
}

/// The horizontal direction across a passage, on the side of `before`.
Vec3d across(const Vec3d& tangent, const SectionFrame& frame, const Vec3d& before) {
  const Vec3d level = in_plan(tangent);
  Vec3d right = level.length() > kLevel ? level.cross({0, 1, 0}) : in_plan(frame.right);
  if (right.length() < 1e-3) right = before;
  right.normalize();
  return right.dot(before) < -1e-9 && level.length() <= kLevel ? -right : right;
}

Profile profile(const SectionFrame& frame, const Vec3d& right, int station) {
  const Vec3d forward = Vec3d(0, 1, 0).cross(right);
  Profile out;
  double low = kInfinity, high = -kInfinity, bottom = 0;
  const std::vector<Vec2d> outline = frame.section->outline(48);
  for (const Vec2d& corner : outline) {
    const Vec3d offset = frame.right * corner.x + frame.up * corner.y;
    if (offset.y < low) bottom = offset.dot(forward);
    low = std::min(low, offset.y);
    high = std::max(high, offset.y);
    out.point.left_wall = std::min(out.point.left_wall, offset.dot(right));
    out.point.right_wall = std::max(out.point.right_wall, offset.dot(right));
  }
  for (const Vec2d& corner : outline) {
    const Vec3d offset = frame.right * corner.x + frame.up * corner.y;
    out.point.reach = std::max(out.point.reach, std::fabs(offset.dot(forward) - bottom));
  }
  out.point.right = right;
  out.node = {.position = frame.position + forward * bottom,
              .floor = frame.position.y + low,
              .roof = frame.position.y + high,
              .width = out.point.right_wall - out.point.left_wall,
              .station = station};
  return out;
}

/// The frame in the plane across a segment, as segments have it.
SectionFrame turned(SectionFrame frame, const Vec3d& along) {
  const Vec3d right = frame.right - along * frame.right.dot(along);
  if (right.length() < 1e-6) return frame;
  frame.right = right.normalized();
  frame.up = frame.right.cross(along);
  return frame;
}

/// The profiles at both ends of each segment; they differ from those of the next at bends.
std::vector<std::pair<Profile, Profile>> profiles(const Curve& curve,
                                                  const PassageOptions& options) {
  const std::vector<SectionFrame> sections = section_frames(curve, options);
  const std::vector<Vec3d> directions = tangents(curve);
  std::vector<Vec3d> rights;
  for (size_t i = 0; i < curve.size(); ++i)
    rights.push_back(across(directions[i], sections[i], i > 0 ? rights.back() : Vec3d(1, 0, 0)));
  std::vector<std::pair<Profile, Profile>> out;
  for (size_t i = 0; i + 1 < curve.size(); ++i) {
    const Vec3d along = (curve[i + 1].position - curve[i].position).normalized();
    out.emplace_back(profile(turned(sections[i], along), rights[i], curve[i].station),
                     profile(turned(sections[i + 1], along), rights[i + 1], curve[i + 1].station));
  }
  return out;
}

/// The profile at a bend: the larger of those on both sides.
Profile joined(const Profile& a, const Profile& b) {
  Profile out = a;
  out.node.position = (a.node.position + b.node.position) * 0.5;
  out.node.floor = std::min(a.node.floor, b.node.floor);
  out.node.roof = std::max(a.node.roof, b.node.roof);
  out.point.left_wall = std::min(a.point.left_wall, b.point.left_wall);
  out.point.right_wall = std::max(a.point.right_wall, b.point.right_wall);
  out.point.reach = std::max(a.point.reach, b.point.reach);
  out.node.width = out.point.right_wall - out.point.left_wall;
  return out;
}

/// Collects nodes, one for each station.
struct Collector {
  FloorPlan plan;
  std::map<int, int> node_of_station;

  /// `governs`: whether the section of this passage is that of the station.
  int add(const FloorNode& node, bool governs) {
    if (node.station >= 0) {
      const auto [at, added] =
          node_of_station.emplace(node.station, static_cast<int>(plan.nodes.size()));
      if (!added) {
        if (governs) plan.nodes[static_cast<size_t>(at->second)] = node;
        return at->second;
      }
    }
    plan.nodes.push_back(node);
    return static_cast<int>(plan.nodes.size()) - 1;
  }
};

}  // namespace

FloorPlan floor_plan(const network::Network& network, const PassageOptions& options,
                     double spacing) {
  require_valid(options);
  network::require_valid(network);
  const std::vector<Chain> all = chains(network);
  const std::vector<Curve> curves = axes(network, all, options);
  double length = 0;
  for (const Curve& curve : curves)
    if (!curve.empty()) length += arc_lengths(curve).back();
  if (!(length / spacing < kMostPoints))
    throw Error(ErrorCode::too_large,
                fmt::format("passages of {:.0f} m need more than {:.0f} points with a spacing of "
                            "{} m",
                            length, kMostPoints, spacing),
                {}, "use a part of the network");
  Collector out;
  for (size_t k = 0; k < all.size(); ++k) {
    if (curves[k].size() < 2) continue;
    const std::vector<std::pair<Profile, Profile>> here = profiles(curves[k], options);
    FloorLine line;
    const auto append = [&](const Profile& p, bool governs) {
      line.push_back(p.point);
      line.back().node = out.add(p.node, governs);
    };
    append(here.front().first, !all[k].start_meets);
    for (size_t i = 0; i < here.size(); ++i) {
      const auto& [start, end] = here[i];
      const double piece = (end.node.position - start.node.position).length();
      const int parts = std::max(1, static_cast<int>(std::ceil(piece / spacing)));
      for (int j = 1; j < parts; ++j)
        append(mixed(start, end, static_cast<double>(j) / parts), false);
      const bool last = i + 1 == here.size();
      append(last ? end : joined(end, here[i + 1].first), !(last && all[k].end_meets));
    }
    out.plan.lines.push_back(std::move(line));
  }
  return std::move(out.plan);
}

std::vector<std::vector<int>> neighbours(const FloorPlan& plan) {
  std::vector<std::vector<int>> out(plan.nodes.size());
  for (const FloorLine& line : plan.lines)
    for (size_t i = 0; i + 1 < line.size(); ++i) {
      out[static_cast<size_t>(line[i].node)].push_back(line[i + 1].node);
      out[static_cast<size_t>(line[i + 1].node)].push_back(line[i].node);
    }
  return out;
}

double plan_distance(const FloorPlan& plan, int a, int b) {
  return in_plan(plan.nodes[static_cast<size_t>(b)].position -
                 plan.nodes[static_cast<size_t>(a)].position)
      .length();
}

}  // namespace vug::passages
