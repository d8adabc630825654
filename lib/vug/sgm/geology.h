// Material-driven morphing (named as future work in zawadzki2012, section 5): how far a morph may
// go depends on the geological component it happens in.
#pragma once

#include <vug/field/field.h>

#include <string>
#include <vector>

namespace vug::sgm {

/// A body of rock and the range of morph amounts it allows.
struct Component {
  std::string name;    ///< "limestone", "shale", ...
  field::Field body;   ///< Where it is: negative inside.
  double lowest = 0;   ///< Amount at M_P = 0 %, ratio in 0..1.
  double highest = 1;  ///< Amount at M_P = 100 %, ratio in 0..1, at least `lowest`.
};

struct Geology {
  std::vector<Component> components;  ///< The first whose body holds the point decides.

  /// The component at a point, or null between them.
  const Component* at(const Vec3d& point) const;
  /// lowest + (highest - lowest) * amount of the component there; the amount itself elsewhere.
  double amount_at(const Vec3d& point, double amount) const;
  /// Error(bad_input) unless 0 <= lowest <= highest <= 1 for every component.
  void require_valid() const;
};

}  // namespace vug::sgm
