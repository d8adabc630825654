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
         "Words that rules rewrite and a turtle draws: grammar NAME: lsystem { axiom ...  MODULE "
         "-> "
         "MODULES ... }.")
        .cite("prusinkiewicz1990");
    lsystem::describe_system(s);
    s.param("angle", &Options::angle,
            {.doc = "of + - & ^ / \\ without a parameter", .dimension = Dimension::angle})
        .param("step", &Options::step, positive_length("of F, G and f without a parameter"))
        .param("width", &Options::width,
               {.doc = "diameter of stems until ! or F says otherwise",
                .dimension = Dimension::length,
                .min = 0})
        .param("thinner", &Options::thinner,
               {.doc = "what ! without a parameter multiplies the width by", .min = 0})
        .param("tropism", &Options::tropism, {.doc = "what stems turn to: (0, -1, 0) is down"})
        .param("elasticity", &Options::elasticity,
               {.doc = "how much: radians of turn for each F that is square to the tropism"})
        .param("guides", &Options::guides, {.doc = "curves that guide(0), guide(1), ... follow"})
        .param("instances", &Options::instances,
               {.doc = "symbols that set a thing where the turtle is, such as leaf"})
        .param("smooth", &Options::smooth,
               {.doc = "bend of a guide between two cross-sections, at most",
                .dimension = Dimension::angle,
                .min = 0.001,
                .max = 1})
        .param("field", &LSystemBlock::field,
               {.doc = "the solid whose distance and gradient ?D(d, x, y, z) asks for"});
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
  std::call_once(once_, [&] { drawing_ = std::make_shared<const lsystem::Drawing>(draw()); });
  return drawing_;
}

}  // namespace vug::shot
