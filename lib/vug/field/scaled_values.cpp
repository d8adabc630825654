// SPDX-License-Identifier: Apache-2.0
#include <vug/field/modifier.h>
#include <vug/field/scaled_values.h>

namespace vug::field {
namespace {

struct Factor {
  double by;

  template <class T>
  T apply(const T& value, const Point<T>&) const {
    return value * T(by);
  }
  Traits traits(const Traits& child) const {
    return {child.lipschitz * by, Exactness::sign, child.bounds, 0};
  }
  Interval range(Interval child) const { return child * Interval(by); }
};

}  // namespace

Field scaled_values(const Field& field, double factor) {
  if (factor == 1) return field;
  return Field(
      std::make_shared<ModifierNode<Factor>>("scaled values", Factor{factor}, field.node()));
}

}  // namespace vug::field
