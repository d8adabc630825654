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

}  // namespace

Field enclosed(const Field& field, const Box3d& box) {
  return intersect({field, Field(std::make_shared<BoxNode>(box))});
}

double radius_about_y(const Box3d& box) {
  const double x = std::max(std::fabs(box.min.x), std::fabs(box.max.x));
  const double z = std::max(std::fabs(box.min.z), std::fabs(box.max.z));
  return std::sqrt(x * x + z * z);
}

}  // namespace vug::field
