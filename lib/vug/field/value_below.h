// SPDX-License-Identifier: Apache-2.0
// Nodes whose value at a single point takes less work if only values below a limit matter.
#pragma once

#include <vug/field/interface_of.h>

namespace vug::field {

class ValueBelow {
 public:
  virtual ~ValueBelow() = default;
  /// The value at `p` if it is below the limit, otherwise any number that is not below the limit.
  virtual double value_below(const Point<double>& p, double limit) const = 0;

 protected:
  ValueBelow() = default;
  ValueBelow(const ValueBelow&) = default;
  ValueBelow& operator=(const ValueBelow&) = default;
};

/// The same of any node.
inline double value_below(const Node& node, const Point<double>& p, double limit) {
  const auto* below = interface_of<ValueBelow>(node);
  return below ? below->value_below(p, limit) : node.eval(p);
}

}  // namespace vug::field
