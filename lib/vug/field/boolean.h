// SPDX-License-Identifier: Apache-2.0
// Union, intersection and difference of any number of fields, with one blend profile.
#pragma once

#include <vug/field/blend.h>
#include <vug/field/field.h>

#include <vector>

namespace vug::field {

/// min over the operands; the empty field without operands.
Field unite(std::vector<Field> operands, const Blend& blend = {});
/// max over at least one operand.
Field intersect(std::vector<Field> operands, const Blend& blend = {});
/// Removes all `cuts` from the base: max(base, -cut, ...).
Field subtract(Field base, std::vector<Field> cuts, const Blend& blend = {});
/// The region inside exactly one of the two: max(min(a, b), -max(a, b)).
Field symmetric_difference(const Field& a, const Field& b, const Blend& blend = {});
/// Exchanges solid and air.
Field complement(const Field& a);
/// (1 - amount) a + amount b (SG+M eq. 5, zawadzki2012), amount in 0..1. Returns the operands
/// themselves at 0 and 1.
Field morph(const Field& a, const Field& b, double amount);
/// A field without a solid: 1e6 m everywhere, as a substitute for infinity, with empty bounds.
Field empty();

}  // namespace vug::field
