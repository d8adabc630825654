// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/field/speleothems/random_curve.h>

#include <algorithm>
#include <cmath>

namespace vug::field {

std::vector<CurvePoint> random_curve(const RandomCurve& curve, const Vec3d& at, const Frame& first,
                                     RandomStream& random) {
  const auto steps = static_cast<size_t>(std::max(1.0, std::ceil(curve.length / curve.step)));
  const double step = curve.length / static_cast<double>(steps);
  // The exact transition of the process over one step.
  const double kept = maths::exp(-step / curve.correlation);
  const double fresh = curve.curvature * std::sqrt(1 - kept * kept);
  double along_normal = curve.curvature * random.normal();
  double along_binormal = curve.curvature * random.normal();
  std::vector<CurvePoint> out{{at, first}};
  for (size_t i = 0; i < steps; ++i) {
    Frame frame = out.back().frame;
    const double bend = std::sqrt(along_normal * along_normal + along_binormal * along_binormal);
    if (bend > 0) {  // An arc of a circle; the frame turns with it and does not twist.
      const Vec3d axis =
          (frame.binormal * along_normal - frame.normal * along_binormal).normalized();
      frame = frame.rotated(axis, 0.5 * bend * step);
      out.push_back({out.back().at + frame.tangent * step, frame.rotated(axis, 0.5 * bend * step)});
    } else {
      out.push_back({out.back().at + frame.tangent * step, frame});
    }
    along_normal = kept * along_normal + fresh * random.normal();
    along_binormal = kept * along_binormal + fresh * random.normal();
  }
  return out;
}

}  // namespace vug::field
