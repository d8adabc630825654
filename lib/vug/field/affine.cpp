#include <vug/field/affine.h>
#include <vug/field/deformer.h>

namespace vug::field {
namespace {

struct Affine {
  Transform forward;  // child's space to outside
  Transform inverse;
  double stretch_in;  // largest stretch of the inverse
  double scale_out;   // smallest stretch of the forward map

  template <class T>
  Point<T> map(const Point<T>& p) const {
    const Vec3d &x = inverse.column(0), &y = inverse.column(1), &z = inverse.column(2);
    const Vec3d& t = inverse.origin();
    return {p.x * T(x.x) + p.y * T(y.x) + p.z * T(z.x) + T(t.x),
            p.x * T(x.y) + p.y * T(y.y) + p.z * T(z.y) + T(t.y),
            p.x * T(x.z) + p.y * T(y.z) + p.z * T(z.z) + T(t.z)};
  }
  Ball map(const Ball& ball) const {
    return {inverse.point(ball.centre), ball.radius * stretch_in};
  }
  double scale() const { return scale_out; }
  Traits traits(const Traits& child) const {
    Traits out = child;
    const double uneven = forward.max_stretch() / forward.min_stretch();  // 1 for similarities
    if (uneven > 1 + 1e-12) out.exactness = std::max(out.exactness, Exactness::bound);
    out.bounds = forward.box(child.bounds);
    out.growth = child.grows() / uneven;
    return out;
  }
};

}  // namespace

Field transformed(const Field& field, const Transform& map) {
  const Transform inverse = map.inverse();
  const double least = map.min_stretch();
  const bool similarity = map.max_stretch() <= least * (1 + 1e-12);
  // A rotation's stretch is 1 to the bit, so that moving a solid does not scale its distances.
  const double scale = similarity && std::fabs(least - 1) < 1e-12 ? 1 : least;
  Affine affine{map, inverse, inverse.max_stretch(), scale};
  return Field(std::make_shared<DeformerNode<Affine>>("transform", affine, field.node()));
}

}  // namespace vug::field
