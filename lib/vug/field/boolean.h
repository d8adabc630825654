// Union, intersection and difference of any number of fields, with one blend profile.
#pragma once

#include <vug/field/blend.h>
#include <vug/field/field.h>

#include <vector>

namespace vug::field {

/// min over the operands. Without operands: the empty field.
Field unite(std::vector<Field> operands, const Blend& blend = {});
/// max over the operands; at least one.
Field intersect(std::vector<Field> operands, const Blend& blend = {});
/// base without every one of `cuts`: max(base, -cut, ...).
Field subtract(Field base, std::vector<Field> cuts, const Blend& blend = {});
/// Where exactly one of the two is: max(min(a, b), -max(a, b)).
Field symmetric_difference(const Field& a, const Field& b, const Blend& blend = {});
/// Solid and air exchanged.
Field complement(const Field& a);
/// (1 - amount) a + amount b (SG+M eq. 5, zawadzki2012), amount in 0..1; the very fields at 0
/// and 1.
Field morph(const Field& a, const Field& b, double amount);
/// A field without a solid: +infinity-like everywhere (1e6 m), bounds empty.
Field empty();

}  // namespace vug::field
