// SPDX-License-Identifier: Apache-2.0
#include <vug/field/enclosing_ball.h>
#include <vug/passages/lines/along_flow.h>
#include <vug/passages/lines/line_bvh.h>
#include <vug/passages/sweep/active_set.h>
#include <vug/passages/sweep/batch_box.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

using field::Ball, field::Dual;

constexpr double kLeastWeight = 16;  // The negative logarithm of the least weight.
constexpr size_t kFewLines = 12;     // Larger batches with more lines are divided.

/// The coordinates of a line.
struct LineFrame {
  explicit LineFrame(const AxisLine& line)
      : origin(line.from),
        length(line.vector().length()),
        direction(line.vector() / length),
        up(line.up),
        right(direction.cross(up)),
        along(line.along) {}
  Vec3d origin;
  double length;
  Vec3d direction, up, right;
  double along;

  /// Metres downstream from the start of the passage, upwards and to the right of the axis.
  template <class T>
  Point<T> coordinates(const Point<T>& p) const {
    const Point<T> offset = p - field::constant<T>(origin);
    return {dot(offset, field::constant<T>(direction)) + T(along),
            dot(offset, field::constant<T>(up)), dot(offset, field::constant<T>(right))};
  }
  /// To the line, from coordinates.
  template <class T>
  T distance(const Point<T>& c) const {
    using field::abs, field::max, field::sqrt, field::square;
    const T beyond = max(abs(c.x - T(along + 0.5 * length)) - T(0.5 * length), T(0.0));
    return sqrt(square(beyond) + square(c.y) + square(c.z));
  }
};

template <class T>
T constant_part(const T& x) {
  return x;
}
template <class S>
Dual<S> constant_part(const Dual<S>& x) {
  return {x.v, S(0.0), S(0.0), S(0.0)};
}

class AlongFlow final : public field::EvaluationModes<AlongFlow> {
 public:
  AlongFlow(field::Traits traits, std::vector<AxisLine> lines, field::Noise noise,
            const AlongFlowOptions& options)
      : EvaluationModes(std::move(traits)),
        bvh_(std::move(lines)),
        noise_(std::move(noise)),
        inverse_stretch_(1 / options.stretch),
        inverse_blend_(1 / options.blend),
        reach_(kLeastWeight * options.blend) {
    for (const AxisLine& line : bvh_.lines()) frames_.emplace_back(line);
  }

  template <class T>
  T at(const Point<T>& p) const {
    using field::exp;
    const std::vector<uint32_t> near = near_lines(centre_of(p), 0);
    std::vector<Point<T>> local;
    T least(kFar);
    for (const uint32_t i : near) {
      local.push_back(frames_[i].coordinates(p));
      least = field::min(least, frames_[i].distance(local.back()));
    }
    least = constant_part(least);
    T sum(0.0), weights(0.0);
    for (size_t k = 0; k < near.size(); ++k) {
      const T weight = exp((least - frames_[near[k]].distance(local[k])) * T(inverse_blend_));
      sum = sum + weight * child().eval(stretched(local[k]));
      weights = weights + weight;
    }
    return sum / weights;
  }
  Interval at(const Point<Interval>& p) const { return over(field::enclosing_ball(p)); }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, field::Scratch& scratch) const {
    const Ball ball = box_around(points, static_cast<size_t>(count)).ball();
    const std::vector<uint32_t> near = near_lines(ball.centre, ball.radius);
    if (near.size() > kFewLines && count > 1) {
      fill(points, count / 2, out, scratch);
      return fill(points + count / 2, count - count / 2, out + count / 2, scratch);
    }
    blend(near, points, static_cast<size_t>(count), out, scratch);
  }

  field::Restriction restrict_to(const Ball& ball) const override { return {over(ball), nullptr}; }
  std::string name() const override { return "along_flow"; }
  std::vector<field::NodePtr> children() const override { return {noise_.field.node()}; }

 protected:
  void add_to(Digester& digester) const override {
    digester(bvh_, noise_, inverse_stretch_, inverse_blend_, reach_);
  }

 private:
  static Vec3d centre_of(const Point<double>& p) { return field::vector(p); }
  static Vec3d centre_of(const Point<Dual<double>>& p) { return {p.x.v, p.y.v, p.z.v}; }
  const field::Node& child() const { return *noise_.field.node(); }

  template <class T>
  Point<T> stretched(const Point<T>& c) const {
    return {c.x * T(inverse_stretch_), c.y, c.z};
  }

  /// Bounds of the values in a ball; the tolerance covers batches in single precision.
  Interval over(const Ball& ball) const {
    const double slack = 1e-6 * (1 + traits().lipschitz * (ball.centre.length() + ball.radius));
    const double reach = traits().lipschitz * ball.radius + slack;
    if (!(reach < noise_.range.width())) return noise_.range;
    const double value = at(field::point(ball.centre));
    return intersection(Interval(value - reach, value + reach), noise_.range);
  }

  /// The lines with a weight anywhere in a ball, in ascending order.
  std::vector<uint32_t> near_lines(const Vec3d& centre, double radius) const {
    double limit = bvh_.nearest(centre).distance + 2 * radius + reach_;
    std::vector<uint32_t> out;
    bvh_.search(
        limit, [&](const LineBvh::Node& node) { return node.distance(centre); },
        [&](uint32_t i, const AxisLine&) {
          if (frames_[i].distance(frames_[i].coordinates(field::point(centre))) <= limit)
            out.push_back(i);
        });
    std::sort(out.begin(), out.end());
    return out;
  }

  template <class T>
  void blend(const std::vector<uint32_t>& near, const Point<Pack>* points, size_t count, T* out,
             field::Scratch& scratch) const;

  LineBvh bvh_;
  std::vector<LineFrame> frames_;
  field::Noise noise_;
  double inverse_stretch_, inverse_blend_, reach_;
};

template <class T>
void AlongFlow::blend(const std::vector<uint32_t>& near, const Point<Pack>* points, size_t count,
                      T* out, field::Scratch& scratch) const {
  using field::exp;
  field::Scratch::Frame frame(scratch);
  auto* moved = frame.take<Point<Pack>>(count);
  auto* local = frame.take<Point<T>>(count);
  T* least = frame.take<T>(count);
  T* weights = frame.take<T>(count);
  T* values = frame.take<T>(count);
  for (size_t k = 0; k < count; ++k) {
    const Point<T> p = field::point_for<T>(points[k]);
    least[k] = T(kFar);
    for (const uint32_t i : near)
      least[k] = field::min(least[k], frames_[i].distance(frames_[i].coordinates(p)));
    least[k] = constant_part(least[k]);
    weights[k] = out[k] = T(0.0);
  }
  for (const uint32_t i : near) {
    for (size_t k = 0; k < count; ++k) {
      const Point<T> c = frames_[i].coordinates(field::point_for<T>(points[k]));
      local[k] = stretched(c);
      if constexpr (std::is_same_v<T, Pack>)
        moved[k] = local[k];
      else
        moved[k] = {local[k].x.v, local[k].y.v, local[k].z.v};
      values[k] = T(0.0);
    }
    child().eval(moved, static_cast<int>(count), values, scratch);
    for (size_t k = 0; k < count; ++k) {
      const Point<T> c = frames_[i].coordinates(field::point_for<T>(points[k]));
      if constexpr (!std::is_same_v<T, Pack>)
        values[k] = differentiated(values[k].v, gradient_of(values[k]), local[k]);
      const T weight = exp((least[k] - frames_[i].distance(c)) * T(inverse_blend_));
      out[k] = out[k] + weight * values[k];
      weights[k] = weights[k] + weight;
    }
  }
  for (size_t k = 0; k < count; ++k) out[k] = out[k] / weights[k];
}

}  // namespace

field::Noise along_flow(std::vector<AxisLine> lines, const field::Noise& noise,
                        const AlongFlowOptions& options) {
  field::Traits traits;
  traits.lipschitz = noise.field.lipschitz() * std::max(1.0, 1 / options.stretch) +
                     0.5 * noise.range.width() / options.blend;
  traits.exactness = field::Exactness::sign;
  traits.bounds = infinite_box();
  return {field::Field(std::make_shared<AlongFlow>(traits, std::move(lines), noise, options)),
          noise.range};
}

}  // namespace vug::passages
