// What the turtle of an L-system's block makes of its word.
#pragma once

#include <vug/field/field.h>
#include <vug/lsystem/system.h>
#include <vug/lsystem/turtle.h>
#include <vug/session/shot.h>

#include <mutex>

namespace vug::session {

struct TurtleBlock : lsystem::TurtleOptions {
  std::optional<field::Field> field;  ///< What ?D asks for.
};

/// The entries of an L-system's block that are its turtle's.
const Schema<TurtleBlock>& turtle_schema();

/// What is drawn, made when it is first asked for.
class LazyDrawing {
 public:
  LazyDrawing(lsystem::SystemPtr system, TurtleBlock turtle)
      : system_(std::move(system)), turtle_(std::move(turtle)) {}

  const TurtleBlock& turtle() const { return turtle_; }
  /// Errors are those of lsystem::derive and lsystem::draw.
  lsystem::DrawingPtr get() const;
  /// The same, made anew.
  lsystem::Drawing make() const;

 private:
  lsystem::SystemPtr system_;
  TurtleBlock turtle_;
  mutable std::once_flag once_;
  mutable lsystem::DrawingPtr drawing_;
};

/// What each L-system of a scene is: bind_lsystem makes no others.
struct DrawnSystem : LSystemPlan {
  DrawnSystem(LSystemPlan plan, TurtleBlock block)
      : LSystemPlan(std::move(plan)), drawing(system, std::move(block)) {}
  LazyDrawing drawing;
};
inline const LazyDrawing& drawing_of(const LSystemPlan& plan) {
  return static_cast<const DrawnSystem&>(plan).drawing;
}

}  // namespace vug::session
