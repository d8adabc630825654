// SPDX-License-Identifier: Apache-2.0
// The solids of speleothems: turned outlines, placed along their axes.
#pragma once

#include <vug/drips/forms.h>
#include <vug/field/field.h>
#include <vug/field/speleothems/stalactite_curve.h>

namespace vug::drips {

/// The outline of a form, x the radius and y the height above its bottom. Trunks have girdles, and
/// no two outlines are equal. `curve` is that of the cave's stalactites, see common_curve.
std::vector<Vec2d> outline_of(const Form& form, const FormOptions& options,
                              const field::StalactiteCurve& curve);

/// The solid of a form.
field::Field form_field(const Form& form, const FormOptions& options,
                        const field::StalactiteCurve& curve);

/// The solids of all.
std::vector<field::Field> form_fields(const std::vector<Form>& forms, const FormOptions& options);

}  // namespace vug::drips
