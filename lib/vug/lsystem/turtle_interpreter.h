// SPDX-License-Identifier: Apache-2.0
// Internal to the turtle: interprets a word module by module (turtle.cpp, turtle_path.cpp) and
// reports brackets and polygons that do not match.
#pragma once

#include <vug/lsystem/drawing_builder.h>
#include <vug/lsystem/turtle_table.h>

namespace vug::lsystem {

class TurtleInterpreter {
 public:
  /// Maximum distance from the start and maximum radius and size, metres.
  static constexpr double kFarthest = 1e9;

  /// Without a builder nothing is drawn. All arguments must outlive this object.
  TurtleInterpreter(const Word& word, const Alphabet& alphabet, const TurtleOptions& options,
                    DrawingBuilder* builder);

  void walk(const std::vector<SymbolId>& symbols, const PoseVisitor& visit);

 private:
  using Parameters = std::span<const double>;

  /// Throws Error(bad_input) that names the current module.
  [[noreturn]] void fail(const std::string& what) const;
  void execute(const SymbolAction& action, Parameters p);
  void rotate(const Vec3d& axis, double angle);
  void set_radius(double radius);
  void level();
  void push();
  void pop();
  void forward(Parameters p, bool drawn);
  void advance(double length, double begun, double radius, bool drawn);
  void follow(double length, double begun, double radius, bool drawn);
  void step(double length, double radius, bool drawn) {
    if (drawn && builder_) builder_->extend(state_, length, radius);
  }
  void bend();
  void begin_guide(Parameters p);
  Vec3d to_world(const Vec3d& v) const;  ///< Transforms a direction from the guide's space.
  void brace(TurtleAction action);

  const Word& word_;
  const Alphabet& alphabet_;
  const TurtleOptions& options_;
  DrawingBuilder* builder_;
  std::vector<SymbolAction> symbol_actions_;
  std::vector<ArcBezier> guides_;
  TurtleState state_;
  std::vector<TurtleState> stack_;
  size_t at_ = 0;
  size_t braces_ = 0;
};

}  // namespace vug::lsystem
