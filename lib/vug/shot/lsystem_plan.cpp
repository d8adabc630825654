// SPDX-License-Identifier: Apache-2.0
#include <vug/field/kind.h>
#include <vug/lsystem/turtle_environment.h>
#include <vug/shot/curves.h>
#include <vug/shot/lsystem_plan.h>

namespace vug::shot {

const Schema<LSystemBlock>& lsystem_schema() {
  static const Schema<LSystemBlock> schema = [] {
    using Options = lsystem::TurtleOptions;
    Schema<LSystemBlock> s("lsystem", "declaration");
    s.doc(
         "An L-system, whose words are rewritten by rules and drawn by a turtle: grammar NAME: "
         "lsystem { axiom ...  MODULE -> MODULES ... }.")
        .cite("prusinkiewicz1990");
    lsystem::describe_system(s);
    s.param("angle", &Options::angle,
            {.doc = "angle of + - & ^ / \\ without a parameter", .dimension = Dimension::angle})
        .param("step", &Options::step, positive_length("of F, G and f without a parameter"))
        .param("width", &Options::width,
               {.doc = "diameter of stems until ! or F says otherwise",
                .dimension = Dimension::length,
                .min = 0})
        .param("thinner", &Options::thinner,
               {.doc = "factor of the width for ! without a parameter", .min = 0})
        .param("tropism", &Options::tropism,
               {.doc = "direction that stems bend towards: (0, -1, 0) is down"})
        .param(
            "elasticity", &Options::elasticity,
            {.doc = "strength of the tropism: radians of rotation for each F perpendicular to it"})
        .param("guides", &Options::guides, {.doc = "curves that guide(0), guide(1), ... follow"})
        .param("instances", &Options::instances,
               {.doc = "symbols that place an instance at the turtle, such as leaf"})
        .param("smooth", &Options::smooth,
               {.doc = "maximum bend of a guide between two cross-sections",
                .dimension = Dimension::angle,
                .min = 0.001,
                .max = 1})
        .param("field", &LSystemBlock::field,
               {.doc = "the solid whose distance and gradient ?D(d, x, y, z) returns"});
    return s;
  }();
  return schema;
}

lsystem::Derivation LSystemPlan::derive(std::optional<int> steps,
                                        std::optional<double> time) const {
  const lsystem::TurtleEnvironment environment(block, block.field);
  return lsystem::derive(
      *system, {.steps = steps, .time = time, .memory = memory(), .environment = &environment});
}

lsystem::Word LSystemPlan::interpret(lsystem::Derivation derivation) const {
  return lsystem::interpret(*system, std::move(derivation), Progress::none(), memory());
}

std::optional<uint64_t> LSystemPlan::memory() const {
  return max_memory_ > 0 ? std::optional(max_memory_) : std::nullopt;
}

lsystem::Drawing LSystemPlan::draw() const {
  return lsystem::draw(interpret(derive()), system->alphabet, block);
}

lsystem::DrawingPtr LSystemPlan::drawing() const {
  // Not std::call_once, because ThreadSanitizer does not expect exceptions from it.
  const std::lock_guard lock(computing_);
  if (!drawing_) drawing_ = std::make_shared<const lsystem::Drawing>(draw());
  return drawing_;
}

}  // namespace vug::shot
