// SPDX-License-Identifier: Apache-2.0
// One operation of a field expression, with five evaluation modes.
#pragma once

#include <vug/base/digester.h>
#include <vug/field/point.h>
#include <vug/field/scratch.h>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace vug::field {

/// The relation between a field's value and the distance, ordered from strong to weak.
enum class Exactness {
  exact,    ///< The signed Euclidean distance to the surface.
  eikonal,  ///< At most that distance, and of slope 1 wherever it is differentiable: minima and
            ///< maxima of distances. First-order distances near the surface need no repair.
  bound,    ///< At most that distance in magnitude: safe as a step length, zero on the surface.
  sign,     ///< Only the sign and the zero set are meaningful; Lipschitz with the stated constant.
};

struct Traits {
  double lipschitz = 1;  ///< |f(p) - f(q)| <= lipschitz * |p - q| everywhere.
  Exactness exactness = Exactness::exact;
  Box3d bounds;       ///< Contains every point with f <= 0; may be infinite or empty.
  double growth = 0;  ///< Growth rate of fields that are not exact; see growth_rate().

  /// f(p) >= growth_rate() * (distance from p to bounds) for every p outside; 1 for exact fields.
  double growth_rate() const { return exactness == Exactness::exact ? 1 : growth; }
  /// A box around every point with f <= level, for offsets and blends.
  Box3d bounds_below(double level) const;
  /// The traits of the field that is moved by a vector.
  Traits translated(const Vec3d& by) const;
};

/// A ball in space, the region that pruning considers.
struct Ball {
  Vec3d centre;
  double radius = 0;
};

class Node;
using NodePtr = std::shared_ptr<const Node>;

/// The restriction of an expression to a ball: bounds of its value there, and a smaller expression
/// with identical values there (null: the node itself).
struct Restriction {
  Interval range;
  NodePtr node;
};

/// Immutable; shared between expressions and threads. Values are in metres, negative inside.
/// Batches map `count` points to `count` values, or to values with their derivatives along the
/// points' coordinates; `out` must not overlap `points`.
class Node {
 public:
  explicit Node(Traits traits) : traits_(std::move(traits)) {}
  virtual ~Node() = default;
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  virtual double eval(const Point<double>& p) const = 0;
  virtual Dual<double> eval(const Point<Dual<double>>& p) const = 0;
  virtual Interval eval(const Point<Interval>& p) const = 0;
  virtual void eval(const Point<Pack>* points, int count, Pack* out, Scratch& scratch) const = 0;
  virtual void eval(const Point<Pack>* points, int count, Dual<Pack>* out,
                    Scratch& scratch) const = 0;

  /// Default: centre value +- lipschitz * radius, with no operand dropped.
  virtual Restriction restrict_to(const Ball& ball) const;

  const Traits& traits() const { return traits_; }
  virtual std::string name() const = 0;
  virtual std::vector<NodePtr> children() const { return {}; }

  /// Identifies the function: nodes of one class, name, parameters and children have the same
  /// digest, and nodes with the same digest have the same values. It does not depend on where or
  /// when the node was made. Computed on the first call; thread-safe.
  Digest digest() const;

  /// The same function moved by a vector, if the node can move its parameters in double precision.
  /// Null: it can only be evaluated at moved points; see translated.h.
  virtual NodePtr translated(const Vec3d&) const { return nullptr; }

 protected:
  /// Adds all parameters and children on which values depend.
  virtual void add_to(Digester& digester) const = 0;
  /// Bounds over a ball from the value at its centre, with a tolerance for single precision.
  Interval centre_form(double value, const Ball& ball) const;

 private:
  Traits traits_;
  /// Threads may compute it at the same time, with the same result.
  mutable std::atomic<uint64_t> digest_high_ = 0, digest_low_ = 0;
  mutable std::atomic<bool> digest_known_ = false;
};

/// Implements the five virtual evaluation modes for Derived from two templates:
///   template <class T> T at(const Point<T>&) const;
///   template <class T> void fill(const Point<Pack>* points, int count, T* out, Scratch&) const;
/// with T a Pack or a Dual<Pack>; point_for<T> converts a point for the formula.
template <class Derived>
class EvaluationModes : public Node {
 public:
  using Node::Node;
  double eval(const Point<double>& p) const final { return self().at(p); }
  Dual<double> eval(const Point<Dual<double>>& p) const final { return self().at(p); }
  Interval eval(const Point<Interval>& p) const final { return self().at(p); }
  void eval(const Point<Pack>* points, int count, Pack* out, Scratch& scratch) const final {
    self().fill(points, count, out, scratch);
  }
  void eval(const Point<Pack>* points, int count, Dual<Pack>* out, Scratch& scratch) const final {
    self().fill(points, count, out, scratch);
  }

 private:
  const Derived& self() const { return static_cast<const Derived&>(*this); }
};

}  // namespace vug::field
