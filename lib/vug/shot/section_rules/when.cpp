// SPDX-License-Identifier: Apache-2.0
// A cross-section under conditions.
#include <vug/shot/section_rules.h>
#include <vug/shot/stage_choice.h>

namespace vug::shot {
namespace {

struct When {
  passages::SectionFamilyPtr section;
  StageChoice stage = StageChoice::any;
  std::optional<double> min_width, max_width, min_ratio, max_ratio, max_dip;
  std::optional<double> thickness;
  Vec3d at{0, 0, 0};
  Vec3d normal{0, 1, 0};

  static void describe(Schema<When>& s) {
    const auto length = [](std::string doc) {
      return ParamSpec{.doc = std::move(doc), .dimension = Dimension::length, .min = 0};
    };
    const auto ratio = [](std::string doc) { return ParamSpec{.doc = std::move(doc), .min = 0}; };
    s.doc(
         "A cross-section for the places along passages that fulfil all conditions, for the list "
         "`sections` of passages(...).")
        .param("section", &When::section, {.doc = "the cross-section", .required = true});
    describe_stage(s);
    s.param("min_width", &When::min_width, length("least width of the passage"))
        .param("max_width", &When::max_width, length("greatest width"))
        .param("min_ratio", &When::min_ratio, ratio("least ratio of the width to the height"))
        .param("max_ratio", &When::max_ratio, ratio("greatest ratio"))
        .param("max_dip", &When::max_dip,
               {.doc = "greatest steepness of the axis",
                .dimension = Dimension::angle,
                .min = 0,
                .max = kPi / 2})
        .param("thickness", &When::thickness,
               positive_length("only within a bed of this thickness, see `at` and `normal`"))
        .param("at", &When::at, any_length("a point on the middle of the bed"))
        .param("normal", &When::normal, {.doc = "direction across the bed, of any length but 0"});
  }
  std::string fault() const {
    if (!(normal.length2() > 0)) return "the normal of a bed must not be zero";
    if (max_width && min_width && *min_width > *max_width)
      return "no width is at least 'min_width' and at most 'max_width'";
    if (max_ratio && min_ratio && *min_ratio > *max_ratio)
      return "no ratio is at least 'min_ratio' and at most 'max_ratio'";
    return "";
  }
};

passages::SectionRule rule_of(const When& p) {
  passages::SectionRule rule;
  rule.family = p.section;
  rule.stage = stage_of(p.stage);
  rule.min_width = p.min_width.value_or(rule.min_width);
  rule.max_width = p.max_width.value_or(rule.max_width);
  rule.min_ratio = p.min_ratio.value_or(rule.min_ratio);
  rule.max_ratio = p.max_ratio.value_or(rule.max_ratio);
  rule.max_dip = p.max_dip.value_or(rule.max_dip);
  if (p.thickness)
    rule.bed = passages::Bed{.point = p.at, .normal = p.normal, .thickness = *p.thickness};
  return rule;
}

}  // namespace
}  // namespace vug::shot

VUG_SECTION_RULE_KIND(when) {
  return make_kind<passages::SectionRule, When>("when", "section rule", rule_of);
}
