// SPDX-License-Identifier: Apache-2.0
// The documentation of `grammar` blocks for `vug list`.
#include <vug/loading/grammar_binding.h>
#include <vug/sgm/bond.h>

namespace vug::loading {
namespace {

ParamInfo choice_param(const std::string& name, std::vector<std::string> choices,
                       const std::string& fallback, const std::string& doc) {
  ParamInfo info;
  info.name = name;
  info.type = "name";
  info.choices = std::move(choices);
  info.fallback = fallback;
  info.doc = doc;
  return info;
}

ParamInfo option(const std::string& name, const std::string& type, const std::string& doc) {
  ParamInfo info;
  info.name = name;
  info.type = type;
  info.doc = doc;
  return info;
}

ParamInfo whole(const std::string& name, double min, double max, const std::string& fallback,
                const std::string& doc) {
  ParamInfo info;
  info.name = name;
  info.type = "whole number";
  info.min = min;
  info.max = max;
  info.fallback = fallback;
  info.doc = doc;
  return info;
}

}  // namespace

const KindInfo& grammar_info() {
  static const KindInfo kind = [] {
    KindInfo info{"grammar",
                  "declaration",
                  "A solid that rules generate: grammar NAME { axiom ...  SYMBOL -> + SHAPE ... }.",
                  "zawadzki2012",
                  {}};
    ParamInfo overlap;
    overlap.name = "overlap";
    overlap.type = "number";
    overlap.min = 0;
    overlap.max = 1;
    overlap.dimension = Dimension::ratio;
    overlap.doc = "penetration of a shape as a fraction of its extent; default: by its operation";
    info.params = {
        choice_param("label", sgm::label_names(), "random", "side to which a shape is attached"),
        option("blend", "blend", "blend between a shape and the existing solid"),
        overlap,
        choice_param("reach", {"local", "whole"}, "local", "range of the effect of a shape"),
        whole("pieces", 0, 1000, "1",
              "number of shapes joined before they are attached; 0 counts as 1"),
        choice_param("piece_label", sgm::label_names(), "random",
                     "side to which each piece is attached"),
        option("slope", "angle",
               "inclination of the direction in which a shape continues the solid"),
        option("azimuth", "angle or list",
               "compass directions of joints, of which a shape follows the nearest"),
        option("within", "field", "solid that must contain the middle of each shape"),
        option("apart", "length", "least distance to shapes that are not neighbours"),
        option("name", "text", "name of the place of a shape, for locator(...)"),
        option("dress", "network",
               "network that is dressed: the rules of Leg, Junction, End and Sump apply to each of "
               "its elements"),
        whole("steps", 1, 1e9, std::to_string(kMaxProductions), "maximum number of productions"),
        whole("limit", 1, 1e9, std::to_string(kMaxSymbols), "maximum number of symbols")};
    return info;
  }();
  return kind;
}

}  // namespace vug::loading
