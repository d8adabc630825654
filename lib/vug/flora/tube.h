// SPDX-License-Identifier: Apache-2.0
// A stem as a solid: a generalised cylinder swept along an axis with rotation-minimising frames,
// with its radius, the displacement at its nodes, and the chambers of a hollow culm. One
// parametrisation serves the field (sweep_field.h) and the mesh (sweep_mesh.h), so that both show
// the same surface.
#pragma once

#include <vug/field/field.h>
#include <vug/flora/node_displacement.h>
#include <vug/lsystem/drawing.h>

#include <optional>

namespace vug::flora {

struct SweepOptions {
  NodeDisplacementOptions displacement;
  int displaced_orders = 2;  ///< Stems of this order and above have no displacement.
  int fold_order = 1;        ///< Stems below this order bend smoothly; others have mitred bends.
  double smooth = 0.05;      ///< Maximum bend of a smooth stem between two cross-sections, radians.
  /// Wall thickness of stems of order 0 as a share of the radius; 0: solid.
  double wall = 0;
  /// Minimum wall thickness in metres, as long as a tenth of the radius stays hollow.
  double min_wall = 0;
  double diaphragm = 0.2;    ///< Thickness of the diaphragms at nodes as a share of the radius.
  bool open = false;         ///< Whether the ends of a hollow stem are cuts that show its chambers.
  double min_radius = 1e-4;  ///< Metres; thinner stems get this radius.

  std::string fault() const;  ///< The first invalid combination as a sentence; empty if valid.
};

/// A cross-section of the tube; the middle line is straight between two of them.
struct Ring {
  Vec3d center;
  Frame frame;  ///< Its plane is normal to the tangent and bisects the bend.
  double along = 0;
  double radius = 0;  ///< Without displacement.
  double age = 0;
};

/// A cavity between two diaphragms, in metres along the axis.
struct Chamber {
  double from = 0, to = 0;
};

/// Grooves fade out towards the middle line, where angles are undefined, between these shares of
/// the radius.
inline constexpr double kGroovesFrom = 0.3, kGroovesTo = 0.7;

class Tube {
 public:
  /// Creates a tube from an axis with at least two stations. `parent_radius` is the radius of the
  /// parent where the stem leaves; the part inside the parent is omitted. Empty if the whole axis
  /// lies inside.
  static std::optional<Tube> make(const lsystem::Axis& axis, double parent_radius,
                                  const SweepOptions& options);

  /// A point in the tube's own coordinates.
  struct Coordinates {
    double along = 0;    ///< Metres along the axis; below start() or above end() beyond the ends.
    double radial = 0;   ///< Metres from the middle line, in the plane of the cross-section.
    double angle = 0;    ///< From the frame's normal, radians.
    size_t segment = 0;  ///< Between rings() of this index and the next.
  };
  /// Valid near the middle line. `segment` is a guess from which the search starts.
  Coordinates coordinates(const Vec3d& p, size_t segment) const;

  Vec3d center(double along) const { return at(along).center; }
  Ring at(double along) const;  ///< Interpolated between rings; clamped to the ends.
  /// A point in the cross-section at `along`.
  Vec3d point(double along, double angle, double out) const;
  Vec3d surface(double along, double angle) const {
    return point(along, angle, displaced(along, angle));
  }
  double radius(double along) const;  ///< Without displacement.
  double displaced(double along, double angle) const;
  double taper(double along) const;  ///< Change of radius() per metre along the axis.
  double inner_radius(double along) const { return hollow_of(radius(along)).height; }

  /// Signed value in metres, negative inside the solid: the distance near the surface up to the
  /// factor slope(), which is also its Lipschitz constant where the coordinates are valid. The
  /// solid has flat ends.
  double value(const Coordinates& coords) const;
  /// Value and spatial gradient at the point p with these coordinates; one-sided where the value
  /// has a crease.
  field::Gradient gradient(const Vec3d& p, const Coordinates& coords) const;
  double slope() const { return slope_; }

  double start() const { return rings_.front().along; }  ///< Metres along the axis.
  double end() const { return rings_.back().along; }
  int order() const { return order_; }
  const std::vector<Ring>& rings() const { return rings_; }
  const NodeDisplacement& displacement() const { return displacement_; }
  const std::vector<Chamber>& chambers() const { return chambers_; }
  bool hollow() const { return !chambers_.empty(); }
  /// Bounds of the displaced surface from the bound of the displacement, not from samples.
  Box3d bounds() const;
  /// Upper bound of the distance of the surface from the middle line at a ring.
  double reach(size_t ring) const { return rings_[ring].radius + displacement_.highest(); }

  void add_to(Digester& digester) const {
    digester(rings_, displacement_, chambers_, wall_, min_wall_, slope_, order_);
  }

 private:
  /// Gradients of the coordinates: metres and radians per metre.
  struct CoordinateGradients {
    Vec3d along, radial, angle;
  };
  /// Radius of the hollow in a stem of that radius, and its derivative (`along`) with respect to
  /// it.
  DisplacementSample hollow_of(double radius) const;
  CoordinateGradients coordinate_gradients(const Vec3d& p, const Coordinates& coords) const;
  field::Gradient radial_value(const Coordinates& coords,
                               const CoordinateGradients& coordinate_gradients) const;
  void set_chambers(double diaphragm, bool open);
  void set_slope();
  size_t segment_at(double along) const;

  std::vector<Ring> rings_;
  NodeDisplacement displacement_;
  std::vector<Chamber> chambers_;
  double wall_ = 0, min_wall_ = 0;
  double slope_ = 1;
  int order_ = 0;
};

/// The tubes of all axes of a drawing that yield one, in order.
std::vector<Tube> tubes(const lsystem::Drawing& drawing, const SweepOptions& options);

}  // namespace vug::flora
