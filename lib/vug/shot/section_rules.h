// SPDX-License-Identifier: Apache-2.0
// Rules that select the cross-sections of passages from their size, zone, steepness and bed.
#pragma once

#include <vug/base/kind.h>
#include <vug/passages/passages.h>

namespace vug::shot {

/// The kinds listed in CMakeLists.txt.
const Kinds<passages::SectionRule>& section_rule_kinds();
using SectionRuleKind = Kind<passages::SectionRule>;
/// Begins the definition of the function that the source of such a kind exports.
#define VUG_SECTION_RULE_KIND(name) VUG_EXPORT_KIND(vug::shot, SectionRuleKind, name##_section_rule)

}  // namespace vug::shot

namespace vug {

template <>
struct ValueTraits<passages::SectionRule> : ObjectTraits<passages::SectionRule> {
  static constexpr const char* kWord = "section rule";
};

}  // namespace vug
