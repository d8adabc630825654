// SPDX-License-Identifier: Apache-2.0
// Sums of gradient noise at decreasing scales, shared by the fractal kinds of noise/.
#pragma once

#include <vug/field/factors.h>
#include <vug/field/lattice.h>
#include <vug/field/noise_node.h>

namespace vug::field {

/// The parameters, as a base of the kinds' structs.
struct OctaveParams {
  Factors scale;  ///< Feature size of the first octave, metres.
  int octaves = 5;
  double lacunarity = 2;  ///< Ratio of the frequencies of successive octaves ...
  double gain = 0.5;      ///< ... and of their amplitudes.
  int seed = 1;
};

template <class P>
Schema<P>& describe_octaves(Schema<P>& s) {
  return s
      .param("scale", &OctaveParams::scale,
             {.doc = "size of the coarsest features; a vector stretches them along the axes",
              .dimension = Dimension::length,
              .min = 0,
              .above_min = true})
      .param("octaves", &OctaveParams::octaves, {.doc = "number of octaves", .min = 1, .max = 16})
      .param("lacunarity", &OctaveParams::lacunarity,
             {.doc = "frequency ratio of successive octaves", .min = 1, .max = 8})
      .param("gain", &OctaveParams::gain,
             {.doc = "amplitude ratio of successive octaves", .min = 0, .max = 1})
      .param("seed", &OctaveParams::seed,
             {.doc = "random seed; each seed gives a different noise"});
}

/// The octaves. Each has its own rotation and offset, so that no plane of lattice points, where
/// gradient noise is zero, is shared by two octaves or aligned with an axis.
class Octaves {
 public:
  explicit Octaves(const OctaveParams& params);

  int count() const { return static_cast<int>(layers_.size()); }
  /// Weights; their squares sum to 1.
  double weight(int i) const { return layer(i).weight; }
  /// The maximum slope of the octave's noise, per metre.
  double slope(int i) const { return layer(i).slope; }

  template <class T>
  T noise(int i, const Point<T>& p) const {
    const Layer& l = layer(i);
    return gradient_noise(Point<T>{row(l, 0, p), row(l, 1, p), row(l, 2, p)}, l.seed);
  }
  /// Bounds over a ball; not evaluated where they would be trivial.
  Interval noise(int i, const Ball& ball) const;
  void add_to(Digester& digester) const { digester(layers_); }

 private:
  struct Layer {
    Vec3d rows[3];
    Vec3d shift;
    double weight = 1;
    double slope = 1;
    uint32_t seed = 0;

    void add_to(Digester& digester) const {
      digester(rows[0], rows[1], rows[2], shift, weight, slope, seed);
    }
  };
  const Layer& layer(int i) const { return layers_[static_cast<size_t>(i)]; }
  template <class T>
  static T row(const Layer& l, int r, const Point<T>& p) {
    return p.x * T(l.rows[r].x) + p.y * T(l.rows[r].y) + p.z * T(l.rows[r].z) + T(l.shift[r]);
  }
  std::vector<Layer> layers_;
};

/// The unmodified noise, as a Shape of Fractal.
struct PlainShape {
  static constexpr double kSlope = 1;
  template <class T>
  static T of(const T& n) {
    return n;
  }
};

/// sum of weight_i * Shape(noise_i). Shape has `template <class T> static T of(const T&)` and
/// `kSlope`, its maximum slope.
template <class Shape>
class Fractal {
 public:
  explicit Fractal(const OctaveParams& params) : octaves_(params) {}

  template <class T>
  T at(const Point<T>& p) const {
    return sum<T>([&](int i) { return octaves_.noise(i, p); });
  }
  Interval over(const Ball& ball) const {
    return sum<Interval>([&](int i) { return octaves_.noise(i, ball); });
  }
  Interval range() const {
    return sum<Interval>([](int) { return Interval(-kGradientNoiseBound, kGradientNoiseBound); });
  }
  double lipschitz() const {
    double total = 0;
    for (int i = 0; i < octaves_.count(); ++i)
      total += octaves_.weight(i) * Shape::kSlope * octaves_.slope(i);
    return total;
  }
  void add_to(Digester& digester) const { digester(octaves_); }

 private:
  template <class T, class Sample>
  T sum(const Sample& sample) const {
    T total(0.0);
    for (int i = 0; i < octaves_.count(); ++i)
      total = total + Shape::template of<T>(sample(i)) * T(octaves_.weight(i));
    return total;
  }
  Octaves octaves_;
};

}  // namespace vug::field
