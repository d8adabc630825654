// SPDX-License-Identifier: Apache-2.0
// Fields for property tests: every kind of the registry with its defaults and with random
// parameters from its schema, and moved by a vector. A new kind is included by its line in the list
// of kinds.
#pragma once

#include <vug/base/rng.h>
#include <vug/field/registry.h>

#include <string>
#include <vector>

namespace vug::field {

struct SweepCase {
  std::string label;  ///< Kind and arguments, sufficient to reproduce it.
  Field field;
};

/// A random value for a parameter of a kind.
Value draw_value(const ParamInfo& info, const std::string& kind, RandomStream& random);
/// Random values for the required parameters and, unless `defaults`, for most of the others.
Arguments draw_arguments(const KindInfo& kind, RandomStream& random, bool defaults = false);

/// The kind with its defaults, then with `count` random sets of compatible parameters.
std::vector<SweepCase> sweep_cases(const FieldKind& kind, int count = 5);
/// The cases of all kinds, and a translated copy of the last one of each kind.
const std::vector<SweepCase>& all_sweep_cases();

/// Runs a check on every case; a failed assertion ends the check of its case only.
template <class Check>
void for_each_case(const Check& check) {
  for (const SweepCase& c : all_sweep_cases()) check(c);
}

/// Uniform in the cube of half-width `reach` about the origin.
Vec3d random_point(RandomStream& random, double reach);
/// Uniform in a ball.
Vec3d random_point(RandomStream& random, const Ball& ball);
/// The region to probe: the field's bounds, as far as they lie within 3 m of the origin.
Box3d probe_box(const Field& field);

}  // namespace vug::field
