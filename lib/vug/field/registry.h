// Every field kind there is, by folder; made from the lists in CMakeLists.txt.
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

/// Makers of blends, for the `blend` of operators: sharp, smooth, round, chamfer.
const Kinds<Blend>& blends();

/// A field by kind name and named values: make("torus", {{"radius", 1.2}, {"tube", 0.4}}).
/// Error(bad_input) with all faults in its message.
Field make(const std::string& kind, const NamedValues& params = {});

/// A field as an argument of another kind.
inline Value as_value(const Field& field) { return ValueTraits<Field>::write(field); }

}  // namespace vug::field
