// SPDX-License-Identifier: Apache-2.0
#include <vug/base/frames.h>
#include <vug/base/maths.h>
#include <vug/field/speleothems/scalenohedron.h>

#include <cmath>

namespace vug::field {
namespace {

// Calcite has c/a = 0.8543 in the axes in which the cleavage rhombohedron is {10-11} (Dana). The
// normal of (hkil) is h a1* + k a2* + l c*; that of (21-31) is at the angle rho from c, and its
// azimuth is 19.1 degrees from that of the rhombohedron, on either side.
constexpr double kAxialRatio = 0.8543;
const double kAcross = std::sqrt(28.0 / 3), kAlong = 1 / kAxialRatio;
const double kFaceCosine = kAlong / std::sqrt(kAcross * kAcross + kAlong * kAlong);
const double kSine = kAcross / std::sqrt(kAcross * kAcross + kAlong * kAlong);

}  // namespace

Scalenohedron::Scalenohedron(const Vec3d& centre, const Vec3d& c, double half, double turn)
    : centre_(centre), axis_(c), half_(half), face_(half * kFaceCosine) {
  const Frame frame = level_frame(c).rotated(c, turn);
  const double aside = maths::atan2(std::sqrt(3.0), 5);  // 19.1 degrees
  for (size_t i = 0; i < normals_.size(); ++i) {
    const double azimuth = 2 * kPi / 3 * static_cast<double>(i / 2) + (i % 2 == 0 ? aside : -aside);
    normals_[i] = c * kFaceCosine + frame.around(azimuth) * kSine;
  }
}

}  // namespace vug::field
