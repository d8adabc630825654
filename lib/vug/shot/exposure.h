// SPDX-License-Identifier: Apache-2.0
// The exposure of a picture: a number of stops, metering, or a physical camera.
#pragma once

#include <vug/base/value_traits.h>

#include <string>
#include <vector>

namespace vug::shot {

struct Exposure {
  enum class Mode {
    stops,      ///< `stops` itself.
    automatic,  ///< Metered from the picture.
    locked,     ///< Metered from the first picture of a sequence.
    physical,   ///< That of a camera with a film speed, an f-number and an exposure time.
  };
  Mode mode = Mode::automatic;
  double stops = 0;

  bool metered() const { return mode == Mode::automatic || mode == Mode::locked; }
  friend bool operator==(const Exposure&, const Exposure&) = default;
};

/// Names of the modes other than `stops`, in the order of the enumeration.
const std::vector<std::string>& exposure_names();

/// A physical camera. Defaults suit a lit cave.
struct PhysicalExposure {
  double iso = 800;
  double f_number = 2.8;
  double time = 0.02;  ///< Exposure time in seconds.
};

/// The stops by which radiance in W/(m^2 sr) is multiplied so that the luminance that saturates the
/// sensor becomes 1: L = 1.2 * 2^EV100 cd/m^2 with EV100 = log2(f_number^2 / time * 100 / iso), by
/// the saturation-based speed of ISO 12232 (cite lagarde2014pbr), and 179 lm/W as for all lights.
double physical_stops(const PhysicalExposure& camera);

}  // namespace vug::shot

template <>
struct vug::ValueTraits<vug::shot::Exposure> {
  static std::string type() { return "number or name"; }
  static std::optional<shot::Exposure> read(const Value& v);
  static Value write(const shot::Exposure& exposure);
};
