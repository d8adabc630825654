// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/base/vec.h>
#include <vug/image/flip.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::image {
namespace {

using Colour = std::array<double, 3>;
using Matrix = std::array<Colour, 3>;

// Linear Rec.709 to XYZ under D65, with the fractions used by the papers' authors.
constexpr Matrix kToXyz = {{{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                            {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                            {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};

// andersson2020flip, section 4: exponents, break point of the error curve, width of an edge in
// degrees.
constexpr double kColourExponent = 0.7, kBendAt = 0.4, kBendTo = 0.95;
constexpr double kFeatureExponent = 0.5, kEdgeWidth = 0.082;

Colour transform(const Matrix& m, const Colour& c) {
  Colour out{};
  for (size_t i = 0; i < 3; ++i) out[i] = m[i][0] * c[0] + m[i][1] * c[1] + m[i][2] * c[2];
  return out;
}

Matrix inverse_matrix(const Matrix& m) {
  const Mat44d full(m[0][0], m[0][1], m[0][2], 0, m[1][0], m[1][1], m[1][2], 0, m[2][0], m[2][1],
                    m[2][2], 0, 0, 0, 0, 1);
  const Mat44d back = full.inverse();
  Matrix out{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out[static_cast<size_t>(i)][static_cast<size_t>(j)] = back[i][j];
  return out;
}

const Matrix& from_xyz() {
  static const Matrix matrix = inverse_matrix(kToXyz);
  return matrix;
}

const Colour& white() {
  static const Colour colour = transform(kToXyz, {1, 1, 1});
  return colour;
}

/// Opponent colours, linear in light: luminance, red-green, blue-yellow.
Colour opponent(const Colour& linear) {
  Colour c = transform(kToXyz, linear);
  for (size_t i = 0; i < 3; ++i) c[i] /= white()[i];
  return {116 * c[1] - 16, 500 * (c[0] - c[1]), 200 * (c[1] - c[2])};
}

Colour linear_of_opponent(const Colour& c) {
  const double y = (c[0] + 16) / 116;
  return transform(from_xyz(),
                   {(y + c[1] / 500) * white()[0], y * white()[1], (y - c[2] / 200) * white()[2]});
}

/// L*a*b* (CIE 1976) with reduced chroma for dark colours after Hunt.
Colour hunt_lab(const Colour& linear) {
  constexpr double kDelta = 6.0 / 29;
  Colour c = transform(kToXyz, linear);
  for (size_t i = 0; i < 3; ++i) {
    const double v = c[i] / white()[i];
    c[i] = v > kDelta * kDelta * kDelta ? maths::pow(v, 1.0 / 3)
                                        : v / (3 * kDelta * kDelta) + 4.0 / 29;
  }
  const double lightness = 116 * c[1] - 16;
  return {lightness, 0.01 * lightness * 500 * (c[0] - c[1]),
          0.01 * lightness * 200 * (c[1] - c[2])};
}

/// The HyAB distance: the sum of the differences in lightness and in chroma.
double hyab(const Colour& a, const Colour& b) {
  const double da = a[1] - b[1], db = a[2] - b[2];
  return std::fabs(a[0] - b[0]) + std::sqrt(da * da + db * db);
}

/// The colour difference in [0, 1]: large differences are compressed into the last twentieth.
double colour_error(const Colour& a, const Colour& b) {
  static const double most =
      maths::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), kColourExponent);
  const double distance = hyab(a, b);
  if (!(distance > 0)) return 0;
  const double error = maths::pow(distance, kColourExponent), bend = kBendAt * most;
  return error < bend ? kBendTo / bend * error
                      : kBendTo + (error - bend) / (most - bend) * (1 - kBendTo);
}

/// Sum of the separable filters of one contrast sensitivity function: weight and width parameter of
/// each Gaussian a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees (table 1 of the paper).
struct Sensitivity {
  std::vector<std::pair<double, double>> gaussians;
};
const std::array<Sensitivity, 3>& sensitivities() {
  static const std::array<Sensitivity, 3> all = {Sensitivity{{{1, 0.0047}}},
                                                 Sensitivity{{{1, 0.0053}}},
                                                 Sensitivity{{{34.1, 0.04}, {13.5, 0.025}}}};
  return all;
}
constexpr double kWidest = 0.04;

Plane sensed(const Plane& in, const Sensitivity& sensitivity, double pixels_per_degree) {
  const int radius =
      static_cast<int>(std::ceil(3 * std::sqrt(kWidest / (2 * kPi * kPi)) * pixels_per_degree));
  std::vector<double> shares;
  std::vector<Plane> parts;
  double total = 0;
  for (const auto& [weight, width] : sensitivity.gaussians) {
    // The same curve in the form of `gaussian`; its own sum in the plane is included in the weight.
    const double sigma = std::sqrt(width / 2) / kPi * pixels_per_degree;
    double sum = 0;
    for (int x = -radius; x <= radius; ++x) sum += maths::exp(-0.5 * x * x / (sigma * sigma));
    const double share = weight * std::sqrt(kPi / width) * sum * sum;
    const Kernel kernel = gaussian(sigma, radius);
    parts.push_back(filtered(in, kernel, kernel));
    shares.push_back(share);
    total += share;
  }
  if (parts.size() == 1) return parts[0];
  Plane out = in;
  for (size_t p = 0; p < out.values.size(); ++p) {
    double sum = 0;
    for (size_t i = 0; i < parts.size(); ++i)
      sum += shares[i] / total * static_cast<double>(parts[i].values[p]);
    out.values[p] = static_cast<float>(sum);
  }
  return out;
}

/// Weights whose positive part sums to 1 and negative part to -1.
Kernel balanced(Kernel kernel) {
  double up = 0, down = 0;
  for (const double w : kernel) (w > 0 ? up : down) += w;
  for (double& w : kernel) w /= w > 0 ? up : -down;
  return kernel;
}

/// The inputs of both halves of the metric for one image.
struct PerceptualFeatures {
  std::vector<Colour> colours;
  std::vector<float> edges, points;  ///< Lengths of first and second derivatives.
};

std::vector<float> lengths(const Plane& a, const Plane& b) {
  std::vector<float> out(a.values.size());
  for (size_t p = 0; p < out.size(); ++p)
    out[p] = std::sqrt(a.values[p] * a.values[p] + b.values[p] * b.values[p]);
  return out;
}

void find_features(const Plane& luminance, double pixels_per_degree, PerceptualFeatures& seen) {
  const double sigma = 0.5 * kEdgeWidth * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  const Kernel smooth = gaussian(sigma, radius);
  Kernel edge, point;
  for (int x = -radius; x <= radius; ++x) {
    const double g = maths::exp(-0.5 * x * x / (sigma * sigma));
    edge.push_back(-x * g);
    point.push_back((x * x / (sigma * sigma) - 1) * g);
  }
  edge = balanced(edge), point = balanced(point);
  seen.edges = lengths(filtered(luminance, edge, smooth), filtered(luminance, smooth, edge));
  seen.points = lengths(filtered(luminance, point, smooth), filtered(luminance, smooth, point));
}

PerceptualFeatures look(const Image& picture, const FlipOptions& options) {
  const size_t count = picture.pixel_count();
  std::array<Plane, 3> planes;
  planes.fill(Plane{picture.width, picture.height, std::vector<float>(count)});
  const std::array<size_t, 3> from = {static_cast<size_t>(picture.find_channel("R")),
                                      static_cast<size_t>(picture.find_channel("G")),
                                      static_cast<size_t>(picture.find_channel("B"))};
  parallel_for(
      count,
      [&](size_t p) {
        Colour c{};
        for (size_t i = 0; i < 3; ++i) {
          const auto v = static_cast<double>(picture.pixels[p * picture.channels.size() + from[i]]);
          c[i] = std::isnan(v) ? 0 : std::clamp(v, 0.0, 1.0);
        }
        c = opponent(c);
        for (size_t i = 0; i < 3; ++i) planes[i].values[p] = static_cast<float>(c[i]);
      },
      4096);
  PerceptualFeatures seen;
  Plane luminance = planes[0];
  for (float& v : luminance.values) v = (v + 16) / 116;
  find_features(luminance, options.pixels_per_degree, seen);
  for (size_t i = 0; i < 3; ++i)
    planes[i] = sensed(planes[i], sensitivities()[i], options.pixels_per_degree);
  seen.colours.resize(count);
  parallel_for(
      count,
      [&](size_t p) {
        Colour c{};
        for (size_t i = 0; i < 3; ++i) c[i] = static_cast<double>(planes[i].values[p]);
        c = linear_of_opponent(c);
        for (double& v : c) v = std::clamp(v, 0.0, 1.0);
        seen.colours[p] = hunt_lab(c);
      },
      4096);
  return seen;
}

}  // namespace

Plane flip(const Image& reference, const Image& test, const FlipOptions& options) {
  const PerceptualFeatures a = look(reference, options), b = look(test, options);
  Plane out{reference.width, reference.height, std::vector<float>(reference.pixel_count())};
  parallel_for(
      out.values.size(),
      [&](size_t p) {
        const double colour = colour_error(a.colours[p], b.colours[p]);
        if (!(colour > 0)) return;
        const double feature = std::max(std::fabs(static_cast<double>(a.edges[p] - b.edges[p])),
                                        std::fabs(static_cast<double>(a.points[p] - b.points[p])));
        const double amplified = maths::pow(feature / std::sqrt(2.0), kFeatureExponent);
        out.values[p] = static_cast<float>(maths::pow(colour, 1 - amplified));
      },
      4096);
  return out;
}

}  // namespace vug::image
