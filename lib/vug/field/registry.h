// Every field kind there is, by folder; made from the lists in CMakeLists.txt.
#pragma once

#include <vug/field/blend_kind.h>
#include <vug/field/kind.h>

#include <utility>

namespace vug::field {

const std::vector<const FieldKind*>& primitives();
const std::vector<const FieldKind*>& operators();
const std::vector<const FieldKind*>& deformers();
const std::vector<const FieldKind*>& details();
/// All of the above.
const std::vector<const FieldKind*>& field_kinds();

/// Makers of blends, for the `blend` of operators: sharp, smooth, round, chamfer.
const std::vector<const BlendKind*>& blends();

/// A field by kind name and named values: make("torus", {{"radius", 1.2}, {"tube", 0.4}}).
/// Error(bad_input) with all faults in its message.
Field make(const std::string& kind, const std::vector<std::pair<std::string, Value>>& params = {});

/// A field as an argument of another kind.
inline Value as_value(const Field& field) { return Object{"field", field}; }

}  // namespace vug::field
