// SPDX-License-Identifier: Apache-2.0
// Copies on a lattice. A surface point q of the solid has its nearest copy at the integer nearest
// to (p - q) / spacing. With the box's half extent e a point p therefore needs only the copies m
// with |m - p / spacing| <= 1/2 + e / spacing, p relative to the box's centre. For an exact field
// their minimum is the exact union of all copies, even if the solid extends beyond its cell; for
// other fields the surface is correct, and far values may jump where the set of copies changes.
#include <vug/base/transform.h>
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/kind.h>
#include <vug/field/material_source.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

struct Repeat {
  Field field;
  Vec3d spacing{2, 0, 2};
  Vec3d counts{0, 0, 0};

  static void describe(Schema<Repeat>& s) {
    s.doc("Copies of a solid on a lattice, in rows about the origin.")
        .param("field", &Repeat::field, {.doc = "the solid to repeat", .required = true})
        .param("spacing", &Repeat::spacing,
               {.doc = "spacing of the copies along each axis; 0 does not repeat along it",
                .dimension = Dimension::length,
                .min = 0})
        .param("counts", &Repeat::counts,
               {.doc = "copies along each axis, whole numbers; 0 for infinitely many",
                .min = 0,
                .max = 1e6});
  }
  std::string fault() const {
    for (int axis = 0; axis < 3; ++axis) {
      if (counts[axis] != std::floor(counts[axis])) return "the counts must be whole numbers";
      const double size = field.bounds().size()[axis];
      if (spacing[axis] > 0 && !(size <= 20 * spacing[axis]))
        return "a repeated solid must be at most 20 times as large as its spacing";
    }
    return field.bounds().isEmpty() ? "there is no solid to repeat" : "";
  }
};

/// The copies along one axis.
struct AxisCopies {
  double spacing = 0;                   // 0: one copy, at 0.
  double start = 0;                     // Position of copy 0.
  double first = 0;                     // Centre of the box of copy 0.
  double half_window = 0;               // 1/2 + e / spacing.
  int window = 1;                       // Copies that may matter for one point.
  double lowest = -1e9, highest = 1e9;  // Range of the first copy in a window.

  /// The index of the window's first copy.
  template <class T>
  T number(const T& x) const {
    if (spacing == 0) return T(0.0);
    const T place = (x - T(first)) * T(1 / spacing) - T(half_window);
    return clamp(-floor(-place), T(lowest), T(highest));
  }
  double position(double number) const { return start + number * spacing; }
};

class RepeatNode final : public EvaluationModes<RepeatNode>, public MaterialSource {
 public:
  RepeatNode(Traits traits, NodePtr child, const AxisCopies (&rows)[3])
      : EvaluationModes(std::move(traits)),
        child_(std::move(child)),
        rows_{rows[0], rows[1], rows[2]} {}

  template <class T>
  T at(const Point<T>& p) const {
    const T number[3] = {rows_[0].number(p.x), rows_[1].number(p.y), rows_[2].number(p.z)};
    T least(1e30);
    for (int i = 0; i < copies(); ++i) least = min(least, child_->eval(seen(p, number, i)));
    return least;
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    Scratch::Frame frame(scratch);
    auto* moved = frame.template take<Point<Pack>>(static_cast<size_t>(count));
    T* next = frame.template take<T>(static_cast<size_t>(count));
    for (int i = 0; i < copies(); ++i) {
      for (int k = 0; k < count; ++k) {
        const Point<Pack>& p = points[k];
        const Pack number[3] = {rows_[0].number(p.x), rows_[1].number(p.y), rows_[2].number(p.z)};
        moved[k] = seen(p, number, i);
      }
      child_->eval(moved, count, i == 0 ? out : next, scratch);
      if (i > 0)
        for (int k = 0; k < count; ++k) out[k] = min(out[k], next[k]);
    }
  }

  /// Within a ball the copies are enumerated if they are few and no others can matter.
  Restriction restrict_to(const Ball& ball) const override {
    double low[3], high[3], count = 1;
    bool one_window = true;
    for (int axis = 0; axis < 3; ++axis) {
      const AxisCopies& row = rows_[axis];
      low[axis] = row.number(ball.centre[axis] - ball.radius);
      const double last = row.number(ball.centre[axis] + ball.radius);
      one_window = one_window && last == low[axis];
      high[axis] = last + row.window - 1;
      count *= high[axis] - low[axis] + 1;
    }
    if (!(count <= 512)) {
      if (traits().exactness == Exactness::sign) return {{-kInfinity, kInfinity}, nullptr};
      return Node::restrict_to(ball);
    }
    std::vector<Field> copies;
    for (double z = low[2]; z <= high[2]; ++z)
      for (double y = low[1]; y <= high[1]; ++y)
        for (double x = low[0]; x <= high[0]; ++x)
          copies.push_back(transformed(
              Field(child_), Transform::translation({rows_[0].position(x), rows_[1].position(y),
                                                     rows_[2].position(z)})));
    const Field all = unite(std::move(copies));
    Restriction out = all.node()->restrict_to(ball);
    if (one_window || traits().exactness != Exactness::sign) {
      if (!out.node) out.node = all.node();
    } else {  // A point's own window may not include the lowest copy.
      out.range.hi = kInfinity;
      out.node = nullptr;
    }
    return out;
  }
  std::string name() const override { return "repeat"; }
  std::vector<NodePtr> children() const override { return {child_}; }

  MaterialSample sample_materials(const Vec3d& p) const override {
    return field::sample_materials(*child_, in_nearest_copy(p));
  }
  Coat coat(const Vec3d& p) const override { return coat_at(*child_, in_nearest_copy(p)); }
  std::optional<Field> material_mean(const MaterialNumber& number) const override {
    if (materials_of(Field(child_)).size() > 1)
      throw Error(ErrorCode::bad_input, "the materials of a repeated solid jump between its copies",
                  {}, "apply made_of or host_rock to the result of 'repeat'");
    return field::material_mean(Field(child_), number);
  }
  std::vector<NodePtr> material_operands() const override { return {child_}; }

 protected:
  void add_to(Digester& digester) const override { digester(child_, rows_[0], rows_[1], rows_[2]); }

 private:
  Vec3d in_nearest_copy(const Vec3d& position) const {
    const Point<double> p = point(position);
    const double number[3] = {rows_[0].number(p.x), rows_[1].number(p.y), rows_[2].number(p.z)};
    Point<double> nearest = seen(p, number, 0);
    double least = child_->eval(nearest);
    for (int i = 1; i < copies(); ++i) {
      const Point<double> other = seen(p, number, i);
      if (const double value = child_->eval(other); value < least) least = value, nearest = other;
    }
    return vector(nearest);
  }
  int copies() const { return rows_[0].window * rows_[1].window * rows_[2].window; }

  template <class T>
  Point<T> seen(const Point<T>& p, const T (&number)[3], int copy) const {
    const int nx = rows_[0].window, ny = rows_[1].window;
    const int step[3] = {copy % nx, copy / nx % ny, copy / nx / ny};
    auto shift = [&](int axis) {
      const AxisCopies& row = rows_[axis];
      return T(row.start) + (number[axis] + T(static_cast<double>(step[axis]))) * T(row.spacing);
    };
    return {p.x - shift(0), p.y - shift(1), p.z - shift(2)};
  }

  NodePtr child_;
  AxisCopies rows_[3];
};

Field repeated(const Repeat& repeat) {
  const Traits& child = repeat.field.node()->traits();
  Traits traits = child;
  // The union of exact fields is exact outside; values of other fields may jump.
  traits.exactness = child.exactness == Exactness::exact ? Exactness::bound : Exactness::sign;
  traits.growth = child.growth_rate();
  AxisCopies rows[3];
  for (int axis = 0; axis < 3; ++axis) {
    AxisCopies& row = rows[axis];
    row.spacing = repeat.spacing[axis];
    if (row.spacing == 0) continue;
    const double extent = 0.5 * child.bounds.size()[axis] / row.spacing;
    row.half_window = 0.5 + extent;
    row.window = std::max(1, static_cast<int>(std::ceil(1 + 2 * extent - 1e-9)));
    const double count = repeat.counts[axis];
    if (count > 0) {
      row.start = -0.5 * (count - 1) * row.spacing;
      row.window = std::min(row.window, static_cast<int>(count));
      row.lowest = 0;
      row.highest = count - row.window;
      traits.bounds.min[axis] += row.start;
      traits.bounds.max[axis] -= row.start;
    } else {
      traits.bounds.min[axis] = -kInfinity;
      traits.bounds.max[axis] = kInfinity;
    }
    row.first = row.start + child.bounds.center()[axis];
  }
  return Field(std::make_shared<RepeatNode>(traits, repeat.field.node(), rows));
}

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(repeat) { return field_kind<Repeat>("repeat", "deformer", repeated); }
