// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/passages/sweep/segment_loft_frame.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <type_traits>

namespace vug::passages {
namespace {

template <class S>
Point<S> offset_from(const Point<S>& p, const Vec3d& start) {
  return {p.x - S(start.x), p.y - S(start.y), p.z - S(start.z)};
}

template <class S>
S along_axis(const Point<S>& offset, const Vec3d& axis) {
  return offset.x * S(axis.x) + offset.y * S(axis.y) + offset.z * S(axis.z);
}

/// The distance of a section as a number that depends on the point through u and v.
double chained(const PlaneDistance<double>& d, double, double) { return d.value; }
template <class S>
Dual<S> chained(const PlaneDistance<S>& d, const Dual<S>& u, const Dual<S>& v) {
  return {d.value, d.du * u.dx + d.dv * v.dx, d.du * u.dy + d.dv * v.dy, d.du * u.dz + d.dv * v.dz};
}

double plain(double x) { return x; }
double plain(const Dual<double>& x) { return x.v; }

Pack lifted(const Pack& d, const Vec3d&, const Vec3d&) { return d; }
Dual<Pack> lifted(const PlaneDistance<Pack>& d, const Vec3d& right, const Vec3d& up) {
  return {d.value, d.du * Pack(right.x) + d.dv * Pack(up.x),
          d.du * Pack(right.y) + d.dv * Pack(up.y), d.du * Pack(right.z) + d.dv * Pack(up.z)};
}

}  // namespace

Segment::Segment(const SectionFrame& from, const SectionFrame& to)
    : start_(from.position), along_(to.position - from.position), length_(along_.length()) {
  if (!(length_ > 0) || !std::isfinite(length_))
    throw Error(ErrorCode::bad_input, "a piece of a passage needs two different finite ends", {},
                "merge stations at the same position");
  along_ /= length_;
  from_ = plane(from);
  to_ = plane(to);
  const SectionTraits &a = from_.section->traits(), &b = to_.section->traits();
  // A circle looks the same in any frame; others may be turned by rounding.
  uniform_ = from_.section == to_.section &&
             (a.core == a.reach || (from_.right - to_.right).length() < 1e-9);
  reach_ = std::max(a.reach, b.reach);
  depth_ = std::max(a.depth, b.depth);
  const auto one = from_.section->ellipse(), other = to_.section->ellipse();
  if (one && other)
    loft_ = EllipseLoft::between(from_.in_space(one->first), from_.in_space(one->second),
                                 to_.in_space(other->first), to_.in_space(other->second));
  if (loft_) depth_ = std::max(depth_, loft_->depth());
  const double sigma = uniform_ ? 0 : slope();
  scale_ = 1 / std::sqrt(1 + sigma * sigma);
  find_box();
}

/// The frame turned about the line in both planes, as far as `right` shows.
Segment::Plane Segment::plane(const SectionFrame& frame) const {
  Vec3d right = frame.right - along_ * frame.right.dot(along_);
  if (right.length() < 1e-6) {  // The passage turned by a right angle here.
    right = frame.up.cross(along_) * -1.0;
    if (right.length() < 1e-6) right = along_.cross(Vec3d(along_.y, along_.z, along_.x));
  }
  right.normalize();
  return {right, right.cross(along_), frame.section, frame.section->traits().depth};
}

/// The largest distance of outline points of one section from the outline of the other.
double Segment::difference(const Plane& one, const Plane& other) {
  constexpr int kPoints = 48;
  const std::vector<Vec2d> outline = one.section->outline(kPoints);
  double most = 0, gap = 0;
  for (size_t first = 0; first < outline.size(); first += Pack::kLanes) {
    float u[Pack::kLanes], v[Pack::kLanes], distances[Pack::kLanes];
    for (size_t lane = 0; lane < Pack::kLanes; ++lane) {
      const size_t i = std::min(first + lane, outline.size() - 1);
      const Vec2d& p = outline[i];
      const Vec3d at = one.right * p.x + one.up * p.y;
      u[lane] = static_cast<float>(at.dot(other.right));
      v[lane] = static_cast<float>(at.dot(other.up));
      gap = std::max(gap, (outline[(i + 1) % outline.size()] - p).length());
    }
    const Pack pu = Pack::load(u), pv = Pack::load(v);
    Pack out;
    other.section->distances(&pu, &pv, 1, &out);
    out.store(distances);
    for (const float d : distances) most = std::max(most, static_cast<double>(std::fabs(d)));
  }
  return most + std::min(0.5 * gap, 0.1 * most + 0.01 * gap);
}

/// max |dD/ds|: of a loft, or |D_from - D_to| / L. Exact distances differ most on one of the two
/// outlines: off them, the nearer outline is left at the same rate at most.
double Segment::slope() const {
  if (loft_) return loft_->slope() / length_;
  return std::max(difference(from_, to_), difference(to_, from_)) / length_;
}

template <class T>
T Segment::across(const Plane& plane, const Point<T>& offset) {
  const T u = along_axis(offset, plane.right), v = along_axis(offset, plane.up);
  return chained(plane.section->at(plain(u), plain(v)), u, v);
}

template <class T>
T Segment::finish(const T& from, const T& to, const T& s) const {
  using field::clamp, field::max, field::select, field::square, field::sqrt;
  const T t = clamp(s * T(1 / length_), T(0.0), T(1.0));
  const T plane = uniform_ ? from : from + (to - from) * t;
  const T beyond = max(T(0.0) - s, s - T(length_));
  const T depth = select(s < T(0.0), T(from_.depth), T(to_.depth));
  const T cap = sqrt(square(max(plane + depth, T(0.0))) + square(max(beyond, T(0.0)))) - depth;
  return select(beyond > T(0.0), cap, plane) * T(scale_);
}

Dual<double> Segment::lofted(const Point<double>& p) const {
  const LoftFrame<double> frame(*this);
  const auto at = frame.coordinates(p);
  return frame.finish(loft_->sample(at.u, at.v, at.t), at.s);
}

template <class T>
void Segment::fill_lofted(const Point<Pack>* points, int count, T* out,
                          field::Scratch& scratch) const {
  const LoftFrame<Pack> loft(*this);
  field::Scratch::Frame frame(scratch);
  const auto size = static_cast<size_t>(count);
  Pack* u = frame.take<Pack>(size);
  Pack* v = frame.take<Pack>(size);
  Pack* s = frame.take<Pack>(size);
  Pack* t = frame.take<Pack>(size);
  auto* d = frame.take<EllipseLoft::Sample<Pack>>(size);
  for (int i = 0; i < count; ++i) {
    const auto at = loft.coordinates(points[i]);
    u[i] = at.u;
    v[i] = at.v;
    s[i] = at.s;
    t[i] = at.t;
  }
  loft_->samples(u, v, t, count, d, scratch);
  for (int i = 0; i < count; ++i) {
    if constexpr (std::is_same_v<T, Pack>)
      out[i] = loft.finish(d[i], s[i]).v;
    else
      ::new (out + i) T(loft.finish(d[i], s[i]));
  }
}

template <class T>
T Segment::at(const Point<T>& p) const {
  if (loft_) {
    if constexpr (std::is_same_v<T, double>) {
      return lofted(p).v;
    } else {
      const Dual<double> d = lofted(Point<double>{p.x.v, p.y.v, p.z.v});
      return field::differentiated(d.v, field::gradient_of(d), p);
    }
  }
  const Point<T> offset = offset_from(p, start_);
  const T from = across(from_, offset);
  return finish(from, uniform_ ? from : across(to_, offset), along_axis(offset, along_));
}

template <class D>
void Segment::sample(const Plane& plane, const Point<Pack>* points, int count, D* out,
                     field::Scratch& scratch) const {
  field::Scratch::Frame frame(scratch);
  Pack* u = frame.take<Pack>(static_cast<size_t>(count));
  Pack* v = frame.take<Pack>(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) {
    const Point<Pack> offset = offset_from(points[i], start_);
    u[i] = along_axis(offset, plane.right);
    v[i] = along_axis(offset, plane.up);
  }
  if constexpr (std::is_same_v<D, Pack>)
    plane.section->distances(u, v, count, out);
  else
    plane.section->slopes(u, v, count, out);
}

template <class T>
void Segment::fill(const Point<Pack>* points, int count, T* out, field::Scratch& scratch) const {
  if (loft_) return fill_lofted(points, count, out, scratch);
  using D = std::conditional_t<std::is_same_v<T, Pack>, Pack, PlaneDistance<Pack>>;
  field::Scratch::Frame frame(scratch);
  D* from = frame.template take<D>(static_cast<size_t>(count));
  D* to = from;
  sample(from_, points, count, from, scratch);
  if (!uniform_) {
    to = frame.template take<D>(static_cast<size_t>(count));
    sample(to_, points, count, to, scratch);
  }
  for (int i = 0; i < count; ++i) {
    const T s = along_axis(offset_from(field::point_for<T>(points[i]), start_), along_);
    out[i] = finish(lifted(from[i], from_.right, from_.up), lifted(to[i], to_.right, to_.up), s);
  }
}

template double Segment::at(const Point<double>&) const;
template Dual<double> Segment::at(const Point<Dual<double>>&) const;
template void Segment::fill(const Point<Pack>*, int, Pack*, field::Scratch&) const;
template void Segment::fill(const Point<Pack>*, int, Dual<Pack>*, field::Scratch&) const;

Box3d Segment::bounds() const {
  Box3d box;
  for (const Plane* plane : {&from_, &to_}) {
    const SectionTraits& t = plane->section->traits();
    for (const double s : {-from_.depth, length_ + to_.depth})
      for (const double u : {t.min.x, t.max.x})
        for (const double v : {t.min.y, t.max.y})
          box.extendBy(start_ + along_ * s + plane->right * u + plane->up * v);
  }
  return loft_ ? grown(box, loft_->bulge()) : box;
}

}  // namespace vug::passages
