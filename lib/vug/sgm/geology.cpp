// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/field/material_source.h>
#include <vug/sgm/geology.h>

namespace vug::sgm {

const Component* Geology::at(const Vec3d& point) const {
  for (const Component& component : components)
    if (component.body.value(point) <= 0) return &component;
  return nullptr;
}

double Geology::amount_at(const Vec3d& point, double amount) const {
  const Component* component = at(point);
  if (component) amount = component->lowest + (component->highest - component->lowest) * amount;
  return rock ? amount * (1 - field::hardness_at(*rock, point)) : amount;
}

void Geology::require_valid() const {
  for (const Component& c : components)
    if (!(0 <= c.lowest && c.lowest <= c.highest && c.highest <= 1))
      throw Error(ErrorCode::bad_input,
                  "the morph range of '" + c.name + "' must be increasing and within 0..1");
}

}  // namespace vug::sgm
