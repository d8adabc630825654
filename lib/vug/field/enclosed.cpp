#include <vug/field/boolean.h>
#include <vug/field/enclosed.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

class BoxNode final : public Readings<BoxNode> {
 public:
  explicit BoxNode(const Box3d& box)
      : Readings({1, Exactness::exact, box, 1}), centre_(box.center()), half_(0.5 * box.size()) {}
  template <class T>
  T at(const Point<T>& p) const {
    const Point<T> d = abs(p - constant<T>(centre_)) - constant<T>(half_);
    return length(max(d, 0)) + min(max(max(d.x, d.y), d.z), T(0.0));
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch&) const {
    for (int i = 0; i < count; ++i) out[i] = at(point_for<T>(points[i]));
  }
  std::string name() const override { return "enclosure"; }

 private:
  Vec3d centre_, half_;
};

/// At most the distance: the difference of radii over the steepness of the hull's side.
class SleeveNode final : public Readings<SleeveNode> {
 public:
  explicit SleeveNode(const Sleeve& s)
      : Readings({1, Exactness::bound, infinite_box(), 0}), s_(s), widening_(s.high - s.low) {
    const double slope = widening_ / (s.to - s.from);
    scale_ = 1 / std::sqrt(1 + slope * slope);
  }
  template <class T>
  T at(const Point<T>& p) const {
    const T way = clamp((p.y - T(s_.from)) * T(1 / (s_.to - s_.from)), T(0.0), T(1.0));
    return (length(p.x, p.z) - (T(s_.low) + way * T(widening_))) * T(scale_);
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch&) const {
    for (int i = 0; i < count; ++i) out[i] = at(point_for<T>(points[i]));
  }
  std::string name() const override { return "sleeve"; }

 private:
  Sleeve s_;
  double widening_, scale_ = 1;
};

}  // namespace

Field sleeved(const Field& field, const Sleeve& sleeve) {
  return intersect({field, Field(std::make_shared<SleeveNode>(sleeve))});
}

Field enclosed(const Field& field, const Box3d& box) {
  return intersect({field, Field(std::make_shared<BoxNode>(box))});
}

double radius_about_y(const Box3d& box) {
  const double x = std::max(std::fabs(box.min.x), std::fabs(box.max.x));
  const double z = std::max(std::fabs(box.min.z), std::fabs(box.max.z));
  return std::sqrt(x * x + z * z);
}

}  // namespace vug::field
