// One operation of a field expression, evaluated in five readings.
#pragma once

#include <vug/field/point.h>
#include <vug/field/scratch.h>

#include <memory>
#include <string>
#include <vector>

namespace vug::field {

/// What a field's value says beyond its sign; ordered from most to least.
enum class Exactness {
  exact,    ///< The signed Euclidean distance to the surface.
  eikonal,  ///< At most that distance, and of slope 1 wherever it has one: minima and maxima of
            ///< distances. First-order distances near the surface need no repair.
  bound,    ///< At most that distance in magnitude: safe to step by, zero on the surface.
  sign,     ///< Only the sign and the zero set are meant; Lipschitz with the stated constant.
};

struct Traits {
  double lipschitz = 1;  ///< |f(p) - f(q)| <= lipschitz * |p - q| everywhere.
  Exactness exactness = Exactness::exact;
  Box3d bounds;       ///< Holds every point with f <= 0; may be infinite, or empty.
  double growth = 0;  ///< Promised of fields that are not exact; see growth_rate().

  /// f(p) >= growth_rate() * (distance from p to bounds) for every p outside; exact fields grow
  /// by 1.
  double growth_rate() const { return exactness == Exactness::exact ? 1 : growth; }
  /// A box around every point with f <= level: what offsets and blends need.
  Box3d bounds_below(double level) const;
};

/// A ball of space: what the pruning asks about.
struct Ball {
  Vec3d centre;
  double radius = 0;
};

class Node;
using NodePtr = std::shared_ptr<const Node>;

/// What is left of an expression inside a ball: bounds of its value there, and a smaller
/// expression that has the very same values there (null: the node itself).
struct Restriction {
  Interval range;
  NodePtr node;
};

/// Immutable; shared between expressions and threads. Values are metres, negative inside.
/// Batches: `count` points in, `count` values out, or values with their derivatives along the
/// points' coordinates; `out` may not overlap `points`.
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

  /// Default: centre value +- lipschitz * radius, nothing dropped.
  virtual Restriction restrict_to(const Ball& ball) const;

  const Traits& traits() const { return traits_; }
  virtual std::string name() const = 0;
  virtual std::vector<NodePtr> children() const { return {}; }

 protected:
  /// Bounds over a ball from the value at its centre, with slack for single precision.
  Interval centre_form(double value, const Ball& ball) const;

 private:
  Traits traits_;
};

/// Gives Derived the five virtual readings from two templates:
///   template <class T> T at(const Point<T>&) const;
///   template <class T> void fill(const Point<Pack>* points, int count, T* out, Scratch&) const;
/// with T a Pack or a Dual<Pack>; point_for<T> gives a formula its point.
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
