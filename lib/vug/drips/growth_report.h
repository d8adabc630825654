// SPDX-License-Identifier: Apache-2.0
// Checks of a sequence in which speleothems grow: what appears, breaks or disappears, and the
// greatest steps of the surfaces.
#pragma once

#include <vug/drips/dripstone.h>

#include <map>
#include <string>
#include <vector>

namespace vug::drips {

/// One speleothem at one frame.
struct GrowthEvent {
  int frame = 0;
  std::string kind{};  ///< As in Speleothem.
  int64_t drip = 0;
  double size = 0;  ///< Metres.
};

struct GrowthReport {
  size_t frames = 0, speleothems = 0;  ///< Those of the last frame; flowstone counts its layers.
  GrowthEvent first{};                 ///< The greatest size with which one appears.
  GrowthEvent step{};                  ///< The greatest step of a surface between two frames.
  std::vector<GrowthEvent> broken{};   ///< Stalactites that break; their size is the length lost.
  std::vector<GrowthEvent> lost{};     ///< Those that the frame before had; none unless a parameter
                                       ///< other than the age has keys.
};

/// Receives the speleothems of each frame in turn.
class GrowthCheck {
 public:
  /// `forms`: the options with which they have grown, which give outlines their least radius.
  void add(int frame, const Dripstone& grown, const FormOptions& forms);
  const GrowthReport& report() const { return report_; }

  /// The part of a speleothem outside of the rock: points in the half-plane of its axis, x the
  /// radius and y the height above the place where it is attached, and a shift of the axis.
  struct Shape {
    std::string kind{};
    int64_t drip = 0;
    std::vector<Vec2d> outline{};
    Vec3d shift{0.0};
    double size = 0;      ///< The distance by which it stands out of the rock, metres.
    double broken = 0;    ///< The length that it has lost, metres.
    bool fallen = false;  ///< A piece, which appears when a stalactite breaks.
  };
  using Shapes = std::map<std::string, Shape>;

 private:
  Shapes before_;
  GrowthReport report_;
};

}  // namespace vug::drips
