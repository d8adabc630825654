// A stem as a solid: a generalised cylinder swept along an axis with frames that do not twist, its
// radius, its nodes' relief, and the chambers of a hollow culm. One parametrisation serves the
// field (sweep_field.h) and the mesh (sweep_mesh.h), so that both show the same surface.
#pragma once

#include <vug/field/field.h>
#include <vug/flora/node_displacement.h>
#include <vug/lsystem/drawing.h>

#include <optional>

namespace vug::flora {

struct SweepOptions {
  NodeDisplacementOptions displacement;
  int displaced_orders = 2;  ///< Stems of this order and above have no relief.
  int fold_order = 1;        ///< Stems below this order are smooth where they bend, others folded.
  double smooth = 0.05;      ///< Radians that a smooth stem may bend between two cross-sections.
  double wall = 0;           ///< Of a hollow stem of order 0, a share of its radius; 0: massive.
  double min_wall = 0;  ///< Metres; and at least so thick, while a tenth of the radius is hollow.
  double diaphragm = 0.2;    ///< Thickness of the walls across at nodes, a share of the radius.
  bool open = false;         ///< The ends of a hollow stem are cuts, where its chambers show.
  double min_radius = 1e-4;  ///< Metres; stems thinner than that are this thick.

  std::string fault() const;  ///< A sentence on what does not fit; else empty.
};

/// A cross-section of the tube's middle line, which runs straight between two of them.
struct Ring {
  Vec3d center;
  Frame frame;  ///< Its plane is square to the tangent, which halves the bend.
  double along = 0;
  double radius = 0;  ///< Without relief.
  double age = 0;
};

/// A hollow between two diaphragms, in metres along.
struct Chamber {
  double from = 0, to = 0;
};

/// Grooves fade out towards the middle line, where an angle means nothing: between these shares of
/// the radius.
inline constexpr double kGroovesFrom = 0.3, kGroovesTo = 0.7;

class Tube {
 public:
  /// Of an axis with two stations or more; `parent_radius` is that of the stem where it leaves, and
  /// what lies inside of that is left out. Nothing of an axis that lies in there altogether.
  static std::optional<Tube> make(const lsystem::Axis& axis, double parent_radius,
                                  const SweepOptions& options);

  /// A place in the tube's own coordinates.
  struct Coordinates {
    double along = 0;    ///< Metres along the axis; below start() or above end() beyond the ends.
    double out = 0;      ///< Metres from the middle line, within the cross-section's plane.
    double angle = 0;    ///< From the frame's normal, radians.
    size_t segment = 0;  ///< Between rings() of this index and the next.
  };
  /// Valid near the middle line; `segment` is one near the place, the search goes on from there.
  Coordinates coordinates(const Vec3d& p, size_t segment) const;

  Vec3d center(double along) const { return at(along).center; }
  Ring at(double along) const;  ///< Between rings; kept within the ends.
  /// A point of the cross-section there.
  Vec3d point(double along, double angle, double out) const;
  Vec3d surface(double along, double angle) const {
    return point(along, angle, displaced(along, angle));
  }
  double radius(double along) const;  ///< Without relief.
  double displaced(double along, double angle) const;
  double taper(double along) const;  ///< Change of radius() for a metre along.
  double inner_radius(double along) const { return hollow_of(radius(along)).height; }

  /// Metres, negative inside the solid; true near the surface up to the factor slope() and
  /// Lipschitz with that, where the place is valid. The solid ends flat at both ends.
  double value(const Coordinates& place) const;
  /// The same with its gradient in space, at the point p whose place it is; where the value has a
  /// crease, that of one side.
  field::Gradient gradient(const Vec3d& p, const Coordinates& place) const;
  double slope() const { return slope_; }

  double start() const { return rings_.front().along; }  ///< Metres along the axis.
  double end() const { return rings_.back().along; }
  int order() const { return order_; }
  const std::vector<Ring>& rings() const { return rings_; }
  const NodeDisplacement& displacement() const { return displacement_; }
  const std::vector<Chamber>& chambers() const { return chambers_; }
  bool hollow() const { return !chambers_.empty(); }
  /// Around the displaced surface: made from the relief's bound, not from its samples.
  Box3d bounds() const;
  /// No point of the surface is further from the middle line at a ring.
  double reach(size_t ring) const { return rings_[ring].radius + displacement_.highest(); }

 private:
  /// How a place changes with the point: metres and radians for a metre.
  struct CoordinateGradients {
    Vec3d along, out, angle;
  };
  /// Radius of the hollow in a stem of that radius, and its change (along) for a metre of that.
  DisplacementSample hollow_of(double radius) const;
  CoordinateGradients coordinate_gradients(const Vec3d& p, const Coordinates& place) const;
  field::Gradient skin(const Coordinates& place,
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

/// Of every axis of a drawing that makes one, in their order.
std::vector<Tube> tubes(const lsystem::Drawing& drawing, const SweepOptions& options);

}  // namespace vug::flora
