// SPDX-License-Identifier: Apache-2.0
// Changes of the drips of a roof that were made by hand.
#pragma once

#include <vug/base/digester.h>
#include <vug/base/error.h>
#include <vug/drips/seeps.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace vug::drips {

/// Digests leave out the places of edits in a text, where faults are reported, because they do not
/// change what grows.
struct DripEdits {
  struct Removal {
    int64_t drip = 0;
    SourceLocation where{};
  };
  /// Water drips from the roof above the point `to` instead.
  struct Move {
    int64_t drip = 0;
    Vec3d to{0.0};
    SourceLocation where{};
    void add_to(Digester& digester) const { digester(drip, to); }
  };
  /// Water also drips from the roof above the point `at`.
  struct Addition {
    Vec3d at{0.0};
    double interval = 60;  ///< Seconds between drops.
    double age = 1000;     ///< Years.
    SourceLocation where{};
    void add_to(Digester& digester) const { digester(at, interval, age); }
  };

  /// The number of drips, before those that are added: those with the most water.
  std::optional<size_t> budget{};
  std::vector<Removal> removed{};
  std::vector<Move> moved{};
  std::vector<Addition> added{};

  void add_to(Digester& digester) const;
};

/// Throws Error(bad_input) for a drip that is named twice, a point outside the box of `options`, an
/// interval that is not positive, and an age that is not positive or exceeds that of the oldest
/// drips.
void require_valid(const DripEdits& edits, const SeepOptions& options);

/// Throws Error(bad_input) for a drip that is moved or added in solid rock, or without a roof above
/// it in the box of `options`.
void require_below_roof(const DripEdits& edits, const field::Field& rock,
                        const SeepOptions& options);

/// The seeps after the edits, in the order of their ids; those that were added have the ids -1, -2,
/// ... Throws Error(bad_input) as require_valid, and for a drip that does not exist, a point in
/// rock, and a point without roof above it.
std::vector<Seep> edited(std::vector<Seep> seeps, const field::Field& rock,
                         const SeepOptions& options, const DripEdits& edits);

}  // namespace vug::drips
