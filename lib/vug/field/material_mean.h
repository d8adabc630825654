// SPDX-License-Identifier: Apache-2.0
// The mean over the materials of a field of a number that each has, as an expression with all
// evaluation modes. It is continuous: where materials meet without a width, as in a sharp union,
// the number changes over a contact of its own.
#pragma once

#include <vug/field/field.h>
#include <vug/field/material_mix.h>

#include <functional>
#include <optional>
#include <vector>

namespace vug::field {

/// `lowest` and `highest` bound the values of `number`.
struct MaterialNumber {
  std::function<double(const RockMaterial&)> number;
  Interval range{0, 1};
  double contact = 0.3;  ///< Width of all contacts in metres, above 0.
};

/// The expression, in the unit of the number; nothing if the field has no materials. Throws
/// Error(bad_input) for a repeated solid of several materials, whose mean would have jumps.
std::optional<Field> material_mean(const Field& field, const MaterialNumber& number);

/// A solid and the mean of its number, as an operand of contact_mean.
struct MeanOperand {
  Field solid;
  Field mean;
};
/// The mean where solids meet: that of the solid with the least value, `sign` * value, smoothed
/// over the contact.
Field contact_mean(const std::vector<MeanOperand>& operands, double sign,
                   const MaterialNumber& number);

/// The mean of a body inside it, and `outside` outside of it, smoothed over the contact.
Field contact_mean(const MeanOperand& body, const Field& outside, const MaterialNumber& number);

}  // namespace vug::field
