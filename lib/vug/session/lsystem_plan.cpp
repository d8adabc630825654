#include <vug/field/kind.h>
#include <vug/lsystem/derive.h>
#include <vug/lsystem/turtle_environment.h>
#include <vug/session/curves.h>
#include <vug/session/turtle_block.h>

namespace vug::session {
const Schema<TurtleBlock>& turtle_schema() {
  static const Schema<TurtleBlock> schema = [] {
    using Options = lsystem::TurtleOptions;
    Schema<TurtleBlock> s("lsystem", "grammar");
    s.doc("What a turtle draws of a word: grammar NAME: lsystem { axiom ...  SYMBOL -> WORD ... }.")
        .cite("prusinkiewicz1990")
        .param("angle", &Options::angle,
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
        .param("field", &TurtleBlock::field,
               {.doc = "the solid whose distance and gradient ?D(d, x, y, z) asks for"});
    return s;
  }();
  return schema;
}

lsystem::DrawingPtr LazyDrawing::get() const {
  std::call_once(once_, [&] { drawing_ = std::make_shared<const lsystem::Drawing>(make()); });
  return drawing_;
}

lsystem::Drawing LazyDrawing::make() const {
  const lsystem::TurtleEnvironment environment(turtle_, turtle_.field);
  lsystem::DeriveOptions options;
  options.environment = &environment;
  return lsystem::draw(lsystem::interpreted(*system_, lsystem::derive(*system_, options)),
                       system_->alphabet, turtle_);
}

}  // namespace vug::session
