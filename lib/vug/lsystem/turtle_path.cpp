// SPDX-License-Identifier: Apache-2.0
// Motion of the turtle: straight, along a guide, and bending of stems by tropism.
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/lsystem/turtle_interpreter.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::lsystem {
namespace {

/// v under the smallest rotation that maps one direction to another.
Vec3d rotate_with(const Vec3d& v, const Vec3d& from, const Vec3d& to) {
  const Vec3d axis = from.cross(to);
  const double sine = axis.length();
  if (sine < 1e-12) return v;
  return rotated(v, axis / sine, maths::atan2(sine, from.dot(to)));
}

}  // namespace

Vec3d TurtleInterpreter::to_world(const Vec3d& v) const {
  const auto& axes = state_.guide_axes;
  return axes[0] * v.x + axes[1] * v.y + axes[2] * v.z;
}

void TurtleInterpreter::forward(Parameters p, bool drawn) {
  const double length = p.empty() ? options_.step : p[0];
  if (length < 0 && drawn) fail("negative stem length");
  const bool tapers = drawn && p.size() > 1;
  if (tapers && p[1] < 0) fail("negative stem radius");
  const double begun = tapers && !state_.radius_set ? p[1] : state_.radius;
  if (tapers) set_radius(p[1]);
  if (drawn && length == 0) return;
  if (drawn && builder_) builder_->begin(state_, begun);
  advance(length, begun, state_.radius, drawn);
  if (!(state_.pose.position.length() <= kFarthest))
    fail(fmt::format("the turtle is more than {} m from its start", kFarthest));
  if (state_.elasticity != 0) bend();
}

void TurtleInterpreter::advance(double length, double begun, double radius, bool drawn) {
  if (state_.guide >= 0) {
    const double whole = guides_[static_cast<size_t>(state_.guide)].length() * state_.guide_scale;
    const double bent = std::min(length, whole - state_.guide_along);
    if (bent > 1e-9 * whole) {
      // A remainder beyond the guide's end caused by rounding does not become a separate segment.
      const bool all = length - bent <= 1e-9 * whole;
      const double between = all ? radius : begun + (radius - begun) * bent / length;
      follow(all ? length : bent, begun, between, drawn);
      if (all) return;
      length -= bent;
    }
  }
  state_.pose.position += state_.pose.frame.tangent * length;
  step(length, radius, drawn);
}

/// Bends like the guide on this stretch: the angle between both stays constant.
void TurtleInterpreter::follow(double length, double begun, double radius, bool drawn) {
  const ArcBezier& guide = guides_[static_cast<size_t>(state_.guide)];
  const double scale = state_.guide_scale, from = state_.guide_along;
  constexpr int kProbes = 4;
  double bend = 0;
  for (int i = 0; i < kProbes; ++i) {
    const Vec3d a = guide.tangent((from + length * i / kProbes) / scale),
                b = guide.tangent((from + length * (i + 1) / kProbes) / scale);
    bend += maths::atan2(a.cross(b).length(), a.dot(b));
  }
  const int steps = std::clamp(static_cast<int>(std::ceil(bend / options_.smooth)), 1, 1000);
  Vec3d point = guide.point(from / scale), tangent = to_world(guide.tangent(from / scale));
  for (int i = 1; i <= steps; ++i) {
    const double along = from + length * i / steps;
    const Vec3d next = guide.point(along / scale), ahead = to_world(guide.tangent(along / scale));
    TurtlePose& pose = state_.pose;
    const Vec3d heading = pose.frame.tangent;
    const Vec3d to = pose.position + rotate_with(to_world(next - point) * scale, tangent, heading);
    pose.frame = transported(pose.frame, pose.position, to, rotate_with(ahead, tangent, heading));
    pose.position = to;
    // The last step uses the exact radius: rounding could make 0 negative.
    step(length / steps, i == steps ? radius : begun + (radius - begun) * i / steps, drawn);
    point = next;
    tangent = ahead;
  }
  state_.guide_along = from + length;
}

void TurtleInterpreter::bend() {
  const Vec3d axis = state_.pose.frame.tangent.cross(options_.tropism);
  const double torque = axis.length();
  if (!std::isfinite(torque)) fail("the tropism is too large");
  if (torque > 1e-12) rotate(axis / torque, state_.elasticity * torque);
}

void TurtleInterpreter::begin_guide(Parameters p) {
  const double last = static_cast<double>(guides_.size()) - 1;
  if (p[0] < 0) {
    state_.guide = -1;
    return;
  }
  if (p[0] != std::floor(p[0]) || p[0] > last)
    fail(guides_.empty() ? "no guides are defined"
                         : fmt::format("unknown guide {} (the last is {})", p[0], last));
  state_.guide_scale = p.size() > 1 ? p[1] : 1;
  if (!(state_.guide_scale >= 1e-6 && state_.guide_scale <= 1e6))
    fail("a guide's scale is not between 1e-06 and 1e+06");
  state_.guide = static_cast<int>(p[0]);
  state_.guide_along = 0;
  Frame& frame = state_.pose.frame;
  state_.guide_axes = {-frame.normal, frame.tangent, frame.binormal};
  const Vec3d ahead = to_world(guides_[static_cast<size_t>(state_.guide)].tangent(0));
  frame = Frame{ahead, rotate_with(frame.normal, frame.tangent, ahead), frame.binormal}
              .orthonormalized();
}

}  // namespace vug::lsystem
