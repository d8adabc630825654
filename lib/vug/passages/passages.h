// SPDX-License-Identifier: Apache-2.0
// The passages of a cave as a field: sections along the legs of a network, joined where they meet.
#pragma once

#include <vug/field/field.h>
#include <vug/network/network.h>
#include <vug/passages/curves/meander.h>
#include <vug/passages/curves/smooth.h>
#include <vug/passages/curves/walls.h>
#include <vug/passages/section.h>

#include <optional>
#include <vector>

namespace vug::passages {

/// A bed of rock in which passages have a section of their own.
struct Bed {
  Vec3d point{0.0};       ///< On the middle of the bed.
  Vec3d normal{0, 1, 0};  ///< Direction across the bedding plane; need not be a unit vector.
  double thickness = 1;   ///< Metres.
};

/// Selects the family of sections of some places along a passage.
struct SectionRule {
  SectionFamilyPtr family;
  std::optional<network::Stage> stage =
      std::nullopt;      ///< Only where the passage formed in this zone.
  double min_width = 0;  ///< Metres.
  double max_width = kInfinity;
  double min_ratio = 0;  ///< Width over height.
  double max_ratio = kInfinity;
  double max_dip = kPi / 2;               ///< Steepness in radians.
  std::optional<Bed> bed = std::nullopt;  ///< Only within the bed.
};

/// Canyons where the stage is vadose and the passage is not wider than high, or where the stage is
/// unknown and it is less than half as wide as high; lenses where it is more than twice as wide as
/// high. No rule applies to passages steeper than 60 degrees.
std::vector<SectionRule> default_rules();

inline constexpr double kDefaultChamber = 1.3;
inline constexpr double kDefaultFillet = 0.15;

struct PassageOptions {
  DefaultSize size;                                  ///< Where walls were not measured.
  std::vector<SectionRule> rules = default_rules();  ///< The first that applies counts.
  SectionFamilyPtr section = make_family("tube");    ///< Where no rule applies.
  bool smooth = true;  ///< Curves through the stations instead of straight legs.
  SmoothOptions bends;
  MeanderOptions meanders;
  bool splays = true;  ///< Sections from splays, where a station has enough of them.
  /// Factor of sizes that were not measured where passages meet, 1 to 10.
  double chamber = kDefaultChamber;
  /// Radius of fillets at junctions over half the smaller size, 0 to 1.
  double fillet = kDefaultFillet;
};

/// Throws Error(bad_input) for options out of range.
void require_valid(const PassageOptions& options);

/// The union of all passages, negative inside, in metres; see docs/explanation/passages.md. Its
/// values are at most the distance in magnitude and have the Lipschitz constant 1. Throws
/// Error(bad_input) for a network without legs or with invalid data, and for options out of range.
field::Field passages(const network::Network& network, const PassageOptions& options = {});

}  // namespace vug::passages
