// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/passages/curves/axis.h>
#include <vug/passages/curves/frames.h>
#include <vug/passages/lines/axis_lines.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

/// Whether the water runs against the order of the stations in most of the chain's length.
bool runs_against(const network::Network& network, const Chain& chain) {
  const auto position = [&](int i) { return network.stations[static_cast<size_t>(i)].position; };
  double with = 0;
  for (size_t i = 0; i < chain.legs.size(); ++i) {
    const network::Leg& leg = network.legs[static_cast<size_t>(chain.legs[i])];
    const double length = network::leg_vector(network, leg).length();
    with += position(leg.from) == position(chain.stations[i]) ? length : -length;
  }
  return with < 0;
}

/// The height of the lowest point of a section.
double floor_at(const CurvePoint& point, const Frame& frame) {
  const double below = point.measured ? -point.measured->traits().min.y : 0.5 * point.height;
  return point.position.y - std::fabs(frame.up.y) * below -
         std::fabs(frame.right.y) * 0.5 * point.width;
}

void append(const Curve& curve, std::vector<AxisLine>& out) {
  std::vector<Vec3d> points;
  for (const CurvePoint& p : curve) points.push_back(p.position);
  const std::vector<Frame> across = frames(points, tangents(curve));
  double along = 0;
  for (size_t i = 0; i + 1 < curve.size(); ++i) {
    AxisLine line{.from = points[i], .to = points[i + 1], .along = along};
    const double length = line.vector().length();
    if (!(length > 0)) continue;
    along += length;
    line.floor_from = floor_at(curve[i], across[i]);
    line.floor_to = floor_at(curve[i + 1], across[i + 1]);
    const Vec3d direction = line.vector() / length;
    Vec3d up = across[i].up + across[i + 1].up;
    up -= direction * up.dot(direction);
    if (up.length() < 1e-6) up = direction.cross(across[i].right);
    line.up = up.normalized();
    out.push_back(line);
  }
}

}  // namespace

std::vector<AxisLine> axis_lines(const network::Network& network, const PassageOptions& options) {
  network::require_valid(network);
  const std::vector<Chain> all = chains(network);
  std::vector<Curve> curves = axes(network, all, options);
  std::vector<AxisLine> out;
  for (size_t i = 0; i < all.size(); ++i) {
    if (runs_against(network, all[i])) std::reverse(curves[i].begin(), curves[i].end());
    append(curves[i], out);
  }
  if (out.empty())
    throw Error(ErrorCode::bad_input, "the network has no passages", {},
                "give it legs with a length that do not run over the surface");
  return out;
}

}  // namespace vug::passages
