// Inside of the turtle only: puts what it draws into axes and polygons.
#pragma once

#include <vug/lsystem/turtle.h>

namespace vug::lsystem {

/// What a bracket keeps.
struct TurtleState {
  TurtlePose pose;
  double radius = 0;
  bool radius_set = false;  ///< Since the branch began.
  double age = 0;
  int colour = 0;
  double elasticity = 0;
  uint32_t axis = Axis::kNone;  ///< That the next F goes on with.
  uint32_t parent = Axis::kNone;
  double parent_along = 0;
  int guide = -1;  ///< That it follows; negative: none.
  double guide_along = 0;
  double guide_scale = 1;
  std::array<Vec3d, 3> guide_axes;  ///< Where the guide's x, y and z point.
};

class DrawingBuilder {
 public:
  explicit DrawingBuilder(Drawing& drawing) : drawing_(drawing) {}

  /// Makes sure that there is an axis to go on with from here; `radius` is that of its start.
  void begin(TurtleState& state, double radius);
  /// Goes on to the state's pose, `length` further along.
  void extend(TurtleState& state, double length, double radius);
  void node(TurtleState& state, double size);
  void instance(const TurtleState& state, uint32_t name, std::span<const double> parameters);
  int order(const TurtleState& state) const;
  /// Of the state's axis so far.
  double length(const TurtleState& state) const { return drawing_.axes[state.axis].length(); }

  bool polygon_open() const { return !open_.empty(); }
  size_t open_polygons() const { return open_.size(); }
  void open(const TurtleState& state);
  void corner(const TurtleState& state);
  void close();

 private:
  Drawing& drawing_;
  std::vector<Polygon> open_;
};

}  // namespace vug::lsystem
