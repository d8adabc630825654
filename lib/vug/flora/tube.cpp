// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/flora/tube.h>
#include <vug/flora/tube_rings.h>

#include <algorithm>
#include <cmath>

namespace vug::flora {
namespace {

/// Share of the parent's radius in which a branch is hidden.
constexpr double kHidden = 0.85;
/// Minimum length of a chamber relative to the radius.
constexpr double kMinChamber = 0.01;

}  // namespace

std::string SweepOptions::fault() const {
  if (const char* fault = displacement.fault(); *fault) return fault;
  if (!(wall >= 0 && wall < 1)) return "a wall must be 0 to 100% of the radius";
  if (!(min_wall >= 0)) return "the minimum thickness of a wall must not be negative";
  if (!(diaphragm > 0)) return "a diaphragm must have a thickness above 0";
  if (!(smooth > 0)) return "the bend between two cross-sections must be above 0";
  return "";
}

std::optional<Tube> Tube::make(const lsystem::Axis& axis, double parent_radius,
                               const SweepOptions& options) {
  if (const std::string fault = options.fault(); !fault.empty())
    throw Error(ErrorCode::bad_input, fault);
  Tube tube;
  tube.order_ = axis.order;
  tube.rings_ = make_rings(axis, kHidden * parent_radius, options);
  if (tube.rings_.size() < 2) return std::nullopt;
  std::vector<DisplacedNode> nodes;
  for (const lsystem::Node& node : axis.nodes) {
    if (node.along < tube.start() || node.along > tube.end()) continue;
    const Frame frame = tube.at(node.along).frame;
    DisplacedNode out{node.along, tube.radius(node.along) * node.size, tube.end(), {}};
    for (const Vec3d& direction : node.branches)
      out.angles.push_back(
          maths::atan2(direction.dot(frame.binormal), direction.dot(frame.normal)));
    if (!nodes.empty()) nodes.back().next = out.along;
    nodes.push_back(std::move(out));
  }
  NodeDisplacementOptions displacement = options.displacement;
  if (axis.order >= options.displaced_orders)
    displacement.scar = displacement.ridge = displacement.groove = 0;
  tube.displacement_ = NodeDisplacement(displacement, std::move(nodes));
  tube.wall_ = axis.order == 0 ? options.wall : 0;
  tube.min_wall_ = axis.order == 0 ? options.min_wall : 0;
  if (tube.wall_ > 0 || tube.min_wall_ > 0) tube.set_chambers(options.diaphragm, options.open);
  tube.set_slope();
  return tube;
}

void Tube::set_chambers(double diaphragm, bool open) {
  const double beyond = end() - start();
  Chamber chamber{open ? start() - beyond : start() + diaphragm * radius(start()), 0};
  const auto add = [&](double to) {
    chamber.to = to;
    // A sliver opened by a cut next to a node is not a chamber.
    const double within = std::min(chamber.to, end()) - std::max(chamber.from, start());
    if (within > kMinChamber * radius(chamber.from)) chambers_.push_back(chamber);
  };
  for (const DisplacedNode& node : displacement_.nodes()) {
    const double half = 0.5 * diaphragm * radius(node.along);
    add(node.along - half);
    chamber.from = node.along + half;
  }
  add(open ? end() + beyond : end() - diaphragm * radius(end()));
}

void Tube::set_slope() {
  double taper = 0, tilt = 0, squeeze = 1;
  for (size_t i = 0; i + 1 < rings_.size(); ++i) {
    const Ring &a = rings_[i], &b = rings_[i + 1];
    const double length = (b.center - a.center).length();
    const double half_bend = 0.5 * (b.frame.tangent - a.frame.tangent).length();
    taper = std::max(taper, std::fabs(b.radius - a.radius) / length);
    tilt = std::max(tilt, half_bend);
    // Cross-sections converge on the inner side of a bend.
    const double reach = std::max(this->reach(i), this->reach(i + 1));
    squeeze = std::min(squeeze, 1 - 2 * half_bend * reach / length);
  }
  squeeze = std::max(squeeze, 0.3);
  const double rim = rings_.front().radius > 0 ? displacement_.deepest() : 0;
  double thinnest = rings_.front().radius;
  for (const DisplacedNode& node : displacement_.nodes())
    if (!node.angles.empty()) thinnest = std::min(thinnest, radius(node.next));
  const double out = rim > 0 ? 1 + rim / ((kGroovesTo - kGroovesFrom) * thinnest) : 1;
  const double along = (taper + tilt + displacement_.slope()) / squeeze;
  const double around = rim > 0 ? displacement_.max_angular_slope() / (kGroovesTo * thinnest) : 0;
  slope_ = 1.02 * std::sqrt(out * out + along * along + around * around);
}

size_t Tube::segment_at(double along) const {
  const auto next = std::upper_bound(rings_.begin() + 1, rings_.end() - 1, along,
                                     [](double s, const Ring& ring) { return s < ring.along; });
  return static_cast<size_t>(next - rings_.begin()) - 1;
}

Ring Tube::at(double along) const {
  const size_t i = segment_at(along);
  const Ring &a = rings_[i], &b = rings_[i + 1];
  const double u = std::clamp((along - a.along) / (b.along - a.along), 0.0, 1.0);
  const Vec3d direction = (b.center - a.center).normalized();
  // All planes between two intersecting planes pass through their common line; see coordinates().
  const double before = direction.dot(a.frame.tangent), after = direction.dot(b.frame.tangent);
  const double v = u * after / ((1 - u) * before + u * after);
  Ring out;
  out.center = a.center * (1 - v) + b.center * v;
  out.frame = Frame{a.frame.tangent * (1 - u) + b.frame.tangent * u,
                    a.frame.normal * (1 - u) + b.frame.normal * u, Vec3d(0)}
                  .orthonormalized();
  out.along = a.along * (1 - u) + b.along * u;
  out.radius = a.radius * (1 - u) + b.radius * u;
  out.age = a.age * (1 - u) + b.age * u;
  return out;
}

Tube::Coordinates Tube::coordinates(const Vec3d& p, size_t segment) const {
  size_t i = std::min(segment, rings_.size() - 2);
  double before = 0, after = 0;
  for (size_t moves = 0; moves < rings_.size(); ++moves) {
    before = (p - rings_[i].center).dot(rings_[i].frame.tangent);
    after = (rings_[i + 1].center - p).dot(rings_[i + 1].frame.tangent);
    if (before < 0 && after >= 0 && i > 0)
      --i;
    else if (after < 0 && before >= 0 && i + 2 < rings_.size())
      ++i;
    else
      break;
  }
  Coordinates out;
  out.segment = i;
  Ring ring;
  if (i == 0 && before < 0) {
    ring = rings_[0];
    ring.center += ring.frame.tangent * before;
    ring.along += before;
  } else if (i + 2 == rings_.size() && after < 0) {
    ring = rings_.back();
    ring.center -= ring.frame.tangent * after;
    ring.along -= after;
  } else {
    // Fraction between both planes by the distances to them.
    const double u = before + after > 0 ? std::clamp(before / (before + after), 0.0, 1.0) : 0.5;
    ring = at(rings_[i].along * (1 - u) + rings_[i + 1].along * u);
  }
  const Vec3d off = p - ring.center;
  const double x = off.dot(ring.frame.normal), y = off.dot(ring.frame.binormal);
  out.along = ring.along;
  out.radial = std::sqrt(x * x + y * y);
  out.angle = maths::atan2(y, x);
  return out;
}

Vec3d Tube::point(double along, double angle, double out) const {
  const Ring ring = at(along);
  return ring.center + ring.frame.around(angle) * out;
}

double Tube::radius(double along) const {
  const size_t i = segment_at(along);
  const Ring &a = rings_[i], &b = rings_[i + 1];
  const double u = std::clamp((along - a.along) / (b.along - a.along), 0.0, 1.0);
  return a.radius * (1 - u) + b.radius * u;
}

double Tube::taper(double along) const {
  if (along < start() || along > end()) return 0;
  const size_t i = segment_at(along);
  return (rings_[i + 1].radius - rings_[i].radius) / (rings_[i + 1].along - rings_[i].along);
}

DisplacementSample Tube::hollow_of(double radius) const {
  const double share = 1 - wall_, least = std::min(0.1, share);
  if (radius - min_wall_ >= share * radius) return {share * radius, share};
  if (radius - min_wall_ >= least * radius) return {radius - min_wall_, 1};
  return {least * radius, least};
}

double Tube::displaced(double along, double angle) const {
  return radius(along) + displacement_.rings(along).height -
         displacement_.grooves(along, angle).height;
}

Box3d Tube::bounds() const {
  Box3d box;
  for (size_t i = 0; i + 1 < rings_.size(); ++i) {
    const Vec3d &a = rings_[i].frame.tangent, &b = rings_[i + 1].frame.tangent;
    const double tilt = (b - a).length(), out = std::max(reach(i), reach(i + 1));
    for (const size_t end : {i, i + 1}) {
      const Vec3d& t = rings_[end].frame.tangent;
      Vec3d half;
      for (int axis = 0; axis < 3; ++axis)
        half[axis] = out * std::min(1.0, std::sqrt(std::max(0.0, 1 - t[axis] * t[axis])) + tilt);
      box.extendBy(rings_[end].center - half);
      box.extendBy(rings_[end].center + half);
    }
  }
  return box;
}

std::vector<Tube> tubes(const lsystem::Drawing& drawing, const SweepOptions& options) {
  std::vector<Tube> all;
  all.reserve(drawing.axes.size());
  for (const lsystem::Axis& axis : drawing.axes) {
    const lsystem::Axis* parent =
        axis.parent == lsystem::Axis::kNone ? nullptr : &drawing.axes[axis.parent];
    const double inside = parent && parent->stations.size() > 1
                              ? lsystem::station_at(*parent, axis.parent_along).radius
                              : 0;
    if (auto tube = Tube::make(axis, inside, options)) all.push_back(std::move(*tube));
  }
  return all;
}

}  // namespace vug::flora
