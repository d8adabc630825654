// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/flora/weighted_point.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::flora {

Vec2d weighted_point(const Corners& corners, const std::vector<double>& weights) {
  if (weights.size() != corners.size())
    throw Error(ErrorCode::bad_input,
                fmt::format("{} weights do not match {} corners", weights.size(), corners.size()));
  Vec2d sum(0);
  double total = 0;
  for (size_t i = 0; i < corners.size(); ++i) {
    if (!(weights[i] > 0 && std::isfinite(weights[i])))
      throw Error(ErrorCode::bad_input,
                  fmt::format("weight {} is {}, but must be above 0", i + 1, weights[i]), {},
                  "other weights yield points outside of the polygon");
    sum += corners[i] * weights[i];
    total += weights[i];
  }
  if (!std::isfinite(total)) throw Error(ErrorCode::bad_input, "the sum of the weights overflows");
  return sum / total;
}

}  // namespace vug::flora
