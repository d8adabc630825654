// SPDX-License-Identifier: Apache-2.0
// f(p) = child(p + amount * (n1, n2, n3)(p)). Values are not scaled down: a warped surface keeps
// slopes of about 1, so later offsets and displacements have their nominal size; the worst slope is
// stated as the Lipschitz constant.
#include <vug/field/deformer.h>
#include <vug/field/enclosing_ball.h>
#include <vug/field/octaves.h>

#include <cmath>

namespace vug::field {
namespace {

struct Warp : OctaveParams {
  Field field;
  double amount = 0.3;

  Warp() { octaves = 3; }

  static void describe(Schema<Warp>& s) {
    s.doc("Distorts space by a noise, so that straight features meander.")
        .cite("perlin1985")
        .param("field", &Warp::field, {.doc = "the solid to warp", .required = true})
        .param("amount", &Warp::amount,
               {.doc = "approximate displacement of points",
                .dimension = Dimension::length,
                .min = 0});
    describe_octaves(s);
  }
};

struct Plain {
  static constexpr double kSlope = 1;
  template <class T>
  static T of(const T& n) {
    return n;
  }
};

class Warping {
 public:
  explicit Warping(const Warp& w)
      : amount_(w.amount), noise_{layer(w, 0), layer(w, 1), layer(w, 2)} {}

  template <class T>
  Point<T> map(const Point<T>& p) const {
    return {p.x + along(0, p) * T(amount_), p.y + along(1, p) * T(amount_),
            p.z + along(2, p) * T(amount_)};
  }
  Ball map(const Ball& ball) const {
    const double far = ball.radius + 2 * std::sqrt(3.0) * reach();
    return {vector(map(point(ball.centre))), std::min(ball.radius * stretch(), far)};
  }
  double scale() const { return 1; }
  Traits traits(const Traits& child) const {
    return {child.lipschitz * stretch(), Exactness::sign, grown(child.bounds, reach()),
            child.growth_rate()};
  }

  void add_to(Digester& digester) const { digester(amount_, noise_[0], noise_[1], noise_[2]); }

 private:
  using Layers = Fractal<Plain>;
  static Layers layer(const Warp& w, int axis) {
    OctaveParams params = w;
    params.seed = 3 * w.seed + axis;
    return Layers(params);
  }
  template <class T>
  T along(size_t axis, const Point<T>& p) const {
    if constexpr (std::is_same_v<T, Interval>) {
      return noise_[axis].over(enclosing_ball(p));
    } else {
      return noise_[axis].at(p);
    }
  }
  double reach() const { return amount_ * noise_[0].range().hi; }
  double stretch() const { return 1 + amount_ * std::sqrt(3.0) * noise_[0].lipschitz(); }

  double amount_;
  Layers noise_[3];
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(warp) {
  return field_kind<Warp>("warp", "deformer", [](const Warp& w) {
    return Field(std::make_shared<DeformerNode<Warping>>("warp", Warping(w), w.field.node()));
  });
}
