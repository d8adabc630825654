// SPDX-License-Identifier: Apache-2.0
// All field kinds by folder, generated from lib/families.cmake.
#pragma once

#include <vug/field/blend_kind.h>
#include <vug/field/kind.h>

namespace vug::field {

const Kinds<Field>& primitives();
const Kinds<Field>& operators();
const Kinds<Field>& deformers();
const Kinds<Field>& details();
/// All of the above.
const Kinds<Field>& field_kinds();

/// The kinds of blends for the `blend` parameter of operators: sharp, smooth, round, chamfer.
const Kinds<Blend>& blends();

/// Creates a field from a kind name and named values: make("torus", {{"radius", 1.2}, {"tube",
/// 0.4}}). Throws Error(bad_input) with all faults in its message.
Field make(const std::string& kind, const NamedValues& params = {});

/// A field as an argument of another kind.
inline Value as_value(const Field& field) { return ValueTraits<Field>::write(field); }

}  // namespace vug::field
