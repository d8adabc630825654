// SPDX-License-Identifier: Apache-2.0
// Changes of the drips of a roof that were made by hand.
#pragma once

#include <vug/drips/seeps.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace vug::drips {

struct DripEdits {
  /// Water drips from the roof above the point `to` instead.
  struct Move {
    int64_t drip = 0;
    Vec3d to{0.0};
  };
  /// Water also drips from the roof above the point `at`.
  struct Addition {
    Vec3d at{0.0};
    double interval = 60;  ///< Seconds between drops.
    double age = 1000;     ///< Years.
  };

  /// The number of drips, before those that are added: those with the most water.
  std::optional<size_t> budget{};
  std::vector<int64_t> removed{};
  std::vector<Move> moved{};
  std::vector<Addition> added{};
};

/// Throws Error(bad_input) for a drip that is named twice, a point outside the box of `options`, an
/// interval that is not positive, and an age that is not positive or exceeds that of the oldest
/// drips.
void require_valid(const DripEdits& edits, const SeepOptions& options);

/// Throws Error(bad_input) for a drip that is moved or added in solid rock.
void require_in_air(const DripEdits& edits, const field::Field& rock);

/// The seeps after the edits, in the order of their ids; those that were added have the ids -1, -2,
/// ... Throws Error(bad_input) as require_valid, and for a drip that does not exist, a point in
/// rock, and a point without roof above it.
std::vector<Seep> edited(std::vector<Seep> seeps, const field::Field& rock,
                         const SeepOptions& options, const DripEdits& edits);

}  // namespace vug::drips
