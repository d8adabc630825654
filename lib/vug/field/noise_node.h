// SPDX-License-Identifier: Apache-2.0
// Node and kind of a noise formula, for the files in noise/.
#pragma once

#include <vug/field/enclosing_ball.h>
#include <vug/field/noise.h>

namespace vug::field {

/// N has: template <class T> T at(const Point<T>&) const   for all number types but Interval
///        Interval over(const Ball&) const                  bounds of the value in a ball
///        Interval range() const, double lipschitz() const  over all of space, per metre
template <class N>
class NoiseNode final : public EvaluationModes<NoiseNode<N>> {
 public:
  /// `parameters`: the digest of all parameters of the noise.
  NoiseNode(std::string name, N noise, Digest parameters)
      : EvaluationModes<NoiseNode<N>>({noise.lipschitz(), Exactness::sign, infinite_box(), 0}),
        name_(std::move(name)),
        noise_(std::move(noise)),
        parameters_(parameters) {}

  template <class T>
  T at(const Point<T>& p) const {
    if constexpr (std::is_same_v<T, Interval>) {
      return over(enclosing_ball(p));
    } else {
      return noise_.at(p);
    }
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch&) const {
    for (int i = 0; i < count; ++i) out[i] = noise_.at(point_for<T>(points[i]));
  }
  Restriction restrict_to(const Ball& ball) const override { return {over(ball), nullptr}; }
  std::string name() const override { return name_; }

 protected:
  void add_to(Digester& digester) const override { digester(name_, parameters_); }

 private:
  /// Includes a tolerance for single precision, whose rounding grows with the distance from the
  /// origin.
  Interval over(const Ball& ball) const {
    if (!(ball.radius < 1e9)) return noise_.range();
    const double slack = 1e-6 * (1 + noise_.lipschitz() * (ball.centre.length() + ball.radius));
    return noise_.over(ball) + Interval(-slack, slack);
  }
  std::string name_;
  N noise_;
  Digest parameters_;
};

/// Simple bounds: the value at the centre and the Lipschitz constant, intersected with the range.
template <class N>
Interval centred_bounds(const N& noise, const Ball& ball) {
  const double reach = noise.lipschitz() * ball.radius;
  if (reach >= noise.range().width()) return noise.range();
  const double value = noise.at(point(ball.centre));
  return intersection({value - reach, value + reach}, noise.range());
}

/// The noise with the formula N, which depends on `parameters` alone.
template <class N, class P>
Noise formula_noise(const std::string& name, N formula, const P& parameters) {
  const Interval range = formula.range();
  return Noise(
      Field(std::make_shared<NoiseNode<N>>(name, std::move(formula), digest_of(parameters))),
      range);
}

/// `prepare` converts parameters to the formula.
template <class P, class Prepare>
NoiseKind noise_kind(const std::string& name, Prepare prepare) {
  return make_kind<Noise, P>(name, "noise", [name, prepare](const P& params) {
    return formula_noise(name, prepare(params), params);
  });
}

}  // namespace vug::field
