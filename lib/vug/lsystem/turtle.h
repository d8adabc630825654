// The turtle of [@prusinkiewicz1990]: reads a word and draws (chapter 1, in three dimensions).
// It starts at the origin and heads along +y, its left is -x, its up +z: plane pictures lie in the
// xy plane, seen from +z. The same word gives the same drawing, bit for bit.
#pragma once

#include <vug/base/bezier.h>
#include <vug/lsystem/drawing.h>
#include <vug/lsystem/word.h>

#include <functional>
#include <string>
#include <vector>

namespace vug::lsystem {

struct TurtleOptions {
  double angle = 0.5235987755982988;  ///< Radians that + and the like turn by without parameter.
  double step = 1;                    ///< Metres of F, G and f without parameter.
  double width = 0;                   ///< Diameter of stems until ! says otherwise, metres.
  double thinner = 0.7;               ///< What ! without parameter multiplies the width by.
  Vec3d tropism{0, -1, 0};            ///< What stems turn to, of any length.
  /// e of the torque e H x T: each F turns by e |H x T| radians towards T (ABOP, section 2.1).
  double elasticity = 0;
  std::vector<Bezier> guides = {};          ///< Of guide(0), guide(1), ...
  std::vector<std::string> instances = {};  ///< Names of symbols that set a thing: leaf, flower.
  double smooth = 0.05;                     ///< Radians that a guide may bend between two stations.
  size_t max_depth = 100000;                ///< Brackets within brackets.
};

/// A symbol that means something to the turtle; all others it passes over.
struct TurtleCommand {
  const char* name;
  size_t least, most;  ///< Parameters.
  const char* doc;
};
const std::vector<TurtleCommand>& turtle_commands();

/// Where the turtle is and how it holds itself.
struct TurtlePose {
  Vec3d position{0, 0, 0};
  Frame frame{Vec3d(0, 1, 0), Vec3d(-1, 0, 0), Vec3d(0, 0, 1)};
};

/// Called with the index of each module whose symbol is asked for, and the turtle there.
using PoseVisitor = std::function<void(size_t module, const TurtlePose& pose)>;

/// Error(bad_input) for parameters that are not finite, a negative length or width, a way, width or
/// size beyond 1e9 m, brackets or braces that do not pair, a guide that there is none of; it names
/// the module and its number in the word. Likewise for options that are not finite.
Drawing draw(const Word& word, const Alphabet& alphabet, const TurtleOptions& options = {});

/// Walks without drawing and visits the modules of these symbols: what queries are answered with.
void visit_poses(const Word& word, const Alphabet& alphabet, const TurtleOptions& options,
                 const std::vector<SymbolId>& symbols, const PoseVisitor& visit);

}  // namespace vug::lsystem
