// SPDX-License-Identifier: Apache-2.0
// Columnar joints of cooled lava: prisms side by side, each set back from its neighbours by its own
// amount, with cross joints.
#include <vug/base/rng.h>
#include <vug/field/bedding.h>
#include <vug/field/noise_node.h>
#include <vug/field/speleogens/frame.h>
#include <vug/field/speleogens/plan_columns.h>

namespace vug::field {
namespace {

struct ColumnarJoints {
  double width = 0.5;
  double length = 1.5;
  Vec3d axis{0, 1, 0};
  double joint = 0.12;
  int seed = 1;

  static void describe(Schema<ColumnarJoints>& s) {
    s.doc(
         "Columns of basalt: each has a value of its own between -0.6 and 1, cross joints "
         "divide it, and the joints between columns are at -1. Use an amount of a fifth of the "
         "width.")
        .cite("goehring2008")
        .param("width", &ColumnarJoints::width,
               positive_length("mean width of a column, 20 cm to 2 m in nature"))
        .param("length", &ColumnarJoints::length,
               positive_length("mean distance between cross joints"))
        .param("axis", &ColumnarJoints::axis,
               {.doc = "direction of the columns, perpendicular to the surface from which the lava "
                       "cooled; of any length but 0"})
        .param("joint", &ColumnarJoints::joint,
               {.doc = "width of a joint over that of a column",
                .dimension = Dimension::ratio,
                .min = 0.02,
                .max = 0.5})
        .param("seed", &ColumnarJoints::seed,
               {.doc = "random seed; each seed gives different columns"});
  }
  std::string fault() const { return axis.length2() > 0 ? "" : "the axis must not be zero"; }
};

class Columns {
 public:
  explicit Columns(const ColumnarJoints& c)
      : frame_(c.axis, {1 / c.length, 1 / c.width, 1 / c.width}),
        joint_(c.joint),
        cross_(c.length / c.width),
        lipschitz_(kSpan * (2 + 1) / (c.joint * c.width)),
        seed_(RandomStream(RandomKey(static_cast<uint64_t>(c.seed)).at("columns")).bits()) {}

  template <class T>
  T at(const Point<T>& p) const {
    const Point<T> q = frame_.local(p);
    const auto column = plan_column(q.y, q.z, seed_);
    // Cross joints at heights of the column's own; each block between them is set back by itself.
    const Bed<T> block =
        bed_at(q.x + floor(column.first_random * T(32.0)) + column.first_random, seed_ ^ 0x1b56u);
    const T apart =
        min(column.inside() * T(1 / joint_), min(block.below, block.above) * T(cross_ / joint_));
    const T face = column.second_random * T(1.2) +
                   lattice_random(block.index, seed_ ^ 0x68e3u) * T(kSpan - 1.2);
    const T inside = clamp(apart, T(0.0), T(1.0));
    return T(-1.0) + inside * (T(kLeast) + face * T((kSpan - kLeast) / kSpan));
  }
  Interval over(const Ball& ball) const { return centred_bounds(*this, ball); }
  Interval range() const { return {-1, kSpan - 1}; }
  double lipschitz() const { return lipschitz_; }

 private:
  static constexpr double kSpan = 2, kLeast = 0.4;  // Of faces above the joints.
  FlowFrame frame_;
  double joint_, cross_, lipschitz_;
  uint32_t seed_;
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(columnar_joints) {
  return noise_kind<ColumnarJoints>("columnar_joints",
                                    [](const ColumnarJoints& c) { return Columns(c); });
}
