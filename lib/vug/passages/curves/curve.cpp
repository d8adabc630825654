// SPDX-License-Identifier: Apache-2.0
#include <vug/passages/curves/curve.h>

namespace vug::passages {

std::vector<double> arc_lengths(const Curve& curve) {
  std::vector<double> lengths(curve.size(), 0);
  for (size_t i = 1; i < curve.size(); ++i)
    lengths[i] = lengths[i - 1] + (curve[i].position - curve[i - 1].position).length();
  return lengths;
}

CurvePoint between(const CurvePoint& a, const CurvePoint& b, double t) {
  CurvePoint point;
  point.position = a.position + (b.position - a.position) * t;
  const double share = t * t * (3 - 2 * t);
  point.width = a.width + (b.width - a.width) * share;
  point.height = a.height + (b.height - a.height) * share;
  point.stage = a.stage;
  return point;
}

std::vector<Vec3d> tangents(const Curve& curve) {
  const size_t n = curve.size();
  std::vector<Vec3d> out(n, Vec3d(1, 0, 0));
  for (size_t i = 0; i < n; ++i) {
    const Vec3d before = i > 0 ? curve[i].position - curve[i - 1].position : Vec3d(0.0);
    const Vec3d after = i + 1 < n ? curve[i + 1].position - curve[i].position : Vec3d(0.0);
    const double b = before.length(), a = after.length();
    Vec3d sum(0.0);
    if (b > 0) sum += before * ((a > 0 ? a : 1) / b);
    if (a > 0) sum += after * ((b > 0 ? b : 1) / a);
    // A hairpin has no direction of its own.
    if (sum.length() < 1e-9 * (a + b)) sum = a > 0 ? after : before;
    if (sum.length() > 0) out[i] = sum.normalized();
  }
  return out;
}

}  // namespace vug::passages
