// SPDX-License-Identifier: Apache-2.0
// Material-driven morphing (proposed as future work in zawadzki2012, section 5): the geological
// component at a point limits the amount of a morph.
#pragma once

#include <vug/field/field.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::sgm {

/// A body of rock and the range of morph amounts that it allows.
struct Component {
  std::string name;    ///< "limestone", "shale", ...
  field::Field body;   ///< Its extent: negative inside.
  double lowest = 0;   ///< Amount at M_P = 0 %, ratio in 0..1.
  double highest = 1;  ///< Amount at M_P = 100 %, ratio in 0..1, at least `lowest`.
};

struct Geology {
  std::vector<Component>
      components;  ///< The first component whose body contains the point applies.
  /// A field with materials: the amount of a morph is multiplied by 1 - hardness, the mean over the
  /// materials at its place.
  std::optional<field::Field> rock = std::nullopt;

  /// The component at a point, or null outside all components.
  const Component* at(const Vec3d& point) const;
  /// lowest + (highest - lowest) * amount of the component at the point, outside all components the
  /// amount itself; times 1 - hardness of the rock.
  double amount_at(const Vec3d& point, double amount) const;
  /// Throws Error(bad_input) unless 0 <= lowest <= highest <= 1 for every component.
  void require_valid() const;
};

}  // namespace vug::sgm
