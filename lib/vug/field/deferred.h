// SPDX-License-Identifier: Apache-2.0
// Fields that are computed when they are first evaluated.
#pragma once

#include <vug/base/progress.h>
#include <vug/field/field.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <typeinfo>
#include <utility>

namespace vug::field {

struct DeferredWork {
  std::string stage;  ///< The work as the name of a stage, e.g. "growing popcorn".
  double bytes = 0;   ///< The memory that it needs.
};

namespace detail {
Field deferred(Traits traits, DeferredWork work, Digest inputs, std::function<Field()> make);
}

/// The field `make(inputs...)`. It is called once, when a value is first needed: a scene whose text
/// is only checked computes nothing. `traits` must hold for the result; its bounds may be larger.
/// Interval evaluation gives bounds from the traits alone, and the expression is a leaf until it
/// has been computed. Thread-safe, even if `make` runs a parallel loop. The stage and the inputs
/// identify the field (Node::digest), so `make` is a lambda without captures.
template <class Make, class... Inputs>
requires std::is_empty_v<Make> Field deferred(Traits traits, DeferredWork work, const Make& make,
                                              Inputs... inputs) {
  Digester digester;
  (digester(std::string_view(typeid(Inputs).name()), inputs), ...);
  return detail::deferred(std::move(traits), std::move(work), digester.finish(),
                          [make, inputs...] { return make(inputs...); });
}

/// Computes the deferred fields in `whole` that have not been evaluated, each as a stage. Throws
/// Error(too_large) if one needs more memory than `memory` bytes.
void compute_deferred(const Field& whole, Progress& progress,
                      uint64_t memory = std::numeric_limits<uint64_t>::max());

}  // namespace vug::field
