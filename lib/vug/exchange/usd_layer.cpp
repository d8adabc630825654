// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/trs.h>
#include <vug/exchange/usd_layer.h>

namespace vug::exchange {

void UsdLayer::transform(const Transform& place) {
  if (is_identity(place)) return;
  attribute({"matrix4d", "xformOp:transform"}, UsdMatrix(matrix(place)));
  attribute({"token", "xformOpOrder", true}, UsdTokens{"xformOp:transform"});
}

}  // namespace vug::exchange
