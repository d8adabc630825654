// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/geomagnetism.h>

#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/survey/igrf_table.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::survey {
namespace {

constexpr double kReferenceRadius = 6371.2;  // km
// The ellipsoid WGS 84, in km.
constexpr double kMajorAxis = 6378.137;
constexpr double kMinorAxis = 6356.752314245;

constexpr size_t kOrders = kIgrfDegree + 1;
/// Values by degree and order.
using Triangle = std::array<std::array<double, kOrders>, kOrders>;

/// Geocentric radius in km and latitude, with the angle between the two verticals, in radians.
struct Geocentric {
  double radius = 0;
  double sine = 0, cosine = 0;  ///< Sine and cosine of the latitude.
  double tilt = 0;
};

Geocentric geocentric(const Geographic& place) {
  const double latitude = place.latitude * kPi / 180, height = place.height / 1000;
  const double s = maths::sin(latitude), c = maths::cos(latitude);
  const double a2 = kMajorAxis * kMajorAxis, b2 = kMinorAxis * kMinorAxis;
  const double normal = a2 / std::sqrt(a2 * c * c + b2 * s * s);
  const double x = (normal + height) * c, z = (normal * b2 / a2 + height) * s;
  const double radius = std::hypot(x, z);
  return {radius, z / radius, x / radius, latitude - maths::atan2(z, x)};
}

/// Schmidt semi-normalised associated Legendre functions of the sine of the latitude, and their
/// derivatives by the colatitude.
struct Legendre {
  Triangle value{}, derivative{};

  Legendre(double sine, double cosine) {
    value[0][0] = 1;
    for (size_t n = 1; n < kOrders; ++n) {
      const double degree = static_cast<double>(n);
      const double sectoral = n == 1 ? 1 : std::sqrt(1 - 0.5 / degree);
      value[n][n] = sectoral * cosine * value[n - 1][n - 1];
      derivative[n][n] =
          sectoral * (cosine * derivative[n - 1][n - 1] + sine * value[n - 1][n - 1]);
      for (size_t m = 0; m < n; ++m) {
        const double order = static_cast<double>(m);
        const double below = n < 2 ? 0 : std::sqrt((degree - 1) * (degree - 1) - order * order);
        const double scale = std::sqrt(degree * degree - order * order);
        const double two = n < 2 ? 0 : value[n - 2][m],
                     two_derivative = n < 2 ? 0 : derivative[n - 2][m];
        value[n][m] = ((2 * degree - 1) * sine * value[n - 1][m] - below * two) / scale;
        derivative[n][m] =
            ((2 * degree - 1) * (sine * derivative[n - 1][m] - cosine * value[n - 1][m]) -
             below * two_derivative) /
            scale;
      }
    }
  }
};

/// The interpolated coefficients of a year, in the order of the table.
std::array<double, kIgrfCoefficients> coefficients_of(double year) {
  const double last = kIgrfFirstYear + kIgrfYears * static_cast<double>(kIgrfEpochs - 1);
  if (!(year >= kIgrfFirstYear && year <= last))
    throw Error(ErrorCode::bad_input,
                fmt::format("the magnetic declination of the year {:.0f} is unknown", year), {},
                "the model of the magnetic field reaches from 1900 to 2030; write '*declination' "
                "with a value");
  const double epochs = (year - kIgrfFirstYear) / kIgrfYears;
  const size_t epoch = std::min(static_cast<size_t>(epochs), kIgrfEpochs - 2);
  const double t = epochs - static_cast<double>(epoch);
  std::array<double, kIgrfCoefficients> out;
  for (size_t i = 0; i < kIgrfCoefficients; ++i)
    out[i] = (1 - t) * kIgrf[i][epoch] + t * kIgrf[i][epoch + 1];
  return out;
}

}  // namespace

Vec3d magnetic_field(const Geographic& place, double year) {
  const std::array<double, kIgrfCoefficients> coefficients = coefficients_of(year);
  const Geocentric here = geocentric(place);
  const Legendre legendre(here.sine, here.cosine);
  const double longitude = place.longitude * kPi / 180;
  const double ratio = kReferenceRadius / here.radius;
  double north = 0, east = 0, down = 0, power = ratio * ratio;
  size_t next = 0;
  for (size_t n = 1; n < kOrders; ++n) {
    power *= ratio;
    for (size_t m = 0; m <= n; ++m) {
      const double order = static_cast<double>(m);
      const double g = coefficients[next++], h = m > 0 ? coefficients[next++] : 0;
      const double s = maths::sin(order * longitude), c = maths::cos(order * longitude);
      const double potential = power * (g * c + h * s);
      north += potential * legendre.derivative[n][m];
      east += power * order * (g * s - h * c) * legendre.value[n][m] / std::max(here.cosine, 1e-10);
      down -= static_cast<double>(n + 1) * potential * legendre.value[n][m];
    }
  }
  const double s = maths::sin(here.tilt), c = maths::cos(here.tilt);
  return {c * north + s * down, east, c * down - s * north};
}

double magnetic_declination(const Geographic& place, double year) {
  const Vec3d field = magnetic_field(place, year);
  return maths::atan2(field.y, field.x);
}

}  // namespace vug::survey
