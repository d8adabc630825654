// SPDX-License-Identifier: Apache-2.0
// The turtle interpretation of words by [@prusinkiewicz1990] (chapter 1, in three dimensions).
// The turtle starts at the origin, heads along +y, its left is -x and its up +z: planar drawings
// lie in the xy plane, seen from +z. The same word gives the same drawing, bit for bit.
#pragma once

#include <vug/base/bezier.h>
#include <vug/lsystem/drawing.h>
#include <vug/lsystem/word.h>

#include <functional>
#include <string>
#include <vector>

namespace vug::lsystem {

struct TurtleOptions {
  double angle = 0.5235987755982988;  ///< Default angle of rotations such as +, radians.
  double step = 1;                    ///< Default length of F, G and f, metres.
  double width = 0;                   ///< Initial diameter of stems, metres; set by !.
  double thinner = 0.7;               ///< Factor of the width for ! without a parameter.
  Vec3d tropism{0, -1, 0};            ///< Tropism vector T, of any length.
  /// e of the torque e H x T: each F turns by e |H x T| radians towards T (ABOP, section 2.1).
  double elasticity = 0;
  std::vector<Bezier> guides = {};          ///< Curves of guide(0), guide(1), ...
  std::vector<std::string> instances = {};  ///< Symbols that place an object, e.g. leaf, flower.
  double smooth = 0.05;                     ///< Maximum bend of a guide between stations, radians.
  size_t max_depth = 100000;                ///< Maximum nesting depth of brackets.
};

/// A symbol that the turtle interprets; it ignores all others.
struct TurtleCommand {
  const char* name;
  size_t least, most;  ///< Minimum and maximum number of parameters.
  const char* doc;
};
const std::vector<TurtleCommand>& turtle_commands();

/// The turtle's position and orientation (heading, left, up).
struct TurtlePose {
  Vec3d position{0, 0, 0};
  Frame frame{Vec3d(0, 1, 0), Vec3d(-1, 0, 0), Vec3d(0, 0, 1)};
};

/// Called with the index of each module whose symbol is requested, and the turtle's pose there.
using PoseVisitor = std::function<void(size_t module, const TurtlePose& pose)>;

/// Draws the word. Throws Error(bad_input) for non-finite parameters, a negative length or width, a
/// distance, width or size beyond 1e9 m, unmatched brackets or braces, and unknown guides; it names
/// the module and its number in the word. Also throws Error(bad_input) for non-finite options.
Drawing draw(const Word& word, const Alphabet& alphabet, const TurtleOptions& options = {});

/// Interprets the word without drawing and visits the modules of these symbols; used for queries.
void visit_poses(const Word& word, const Alphabet& alphabet, const TurtleOptions& options,
                 const std::vector<SymbolId>& symbols, const PoseVisitor& visit);

}  // namespace vug::lsystem
