// The base shape while productions change it.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/sgm/bond_pool.h>
#include <vug/sgm/geology.h>
#include <vug/sgm/production_step.h>

namespace vug::sgm {

struct Options {
  /// How far a glued shape is pressed into the base against the label's direction, as a share
  /// of its extent. 0: the walls touch, as definition 5 has it; 0.5: its centre comes to the
  /// bond; 1: it lies inside with its far wall on the base's wall.
  struct Overlap {
    double unite = 0.3;       ///< Round walls that only touch would leave no passage.
    double subtract = 0.3;    ///< A niche; deeper ones sever thin ends more often.
    double intersect = 0.75;  ///< The base's end takes the form of the shape's outer half.
    double morph = 0.5;       ///< Solids further apart than their radii have no morph at 50 %.
    double of(Operation operation) const;
  } overlap;
  Reach reach = Reach::local;
  Geology geology;
};

/// One production as it was done.
struct Placement {
  Operation operation = Operation::unite;
  std::string shape;           ///< Name of the (compound) shape.
  int node = -1;               ///< Leaf of the derivation tree; -1 without a tree.
  Label side = Label::plus_x;  ///< The side it was glued to.
  Transform map;               ///< From the shape's own space to where it was placed.
  field::Field field;          ///< The shape where it was placed.
  double amount = 0;           ///< Of a morph, after the geology had its say.
  double press = 0;            ///< How far it was pressed in after the label was made, metres.
  bool glued = false;          ///< base_bond and shape_bond made a label (before pressing).
  Bond base_bond, shape_bond;  ///< Both consumed. Meaningless unless glued.
  int base_bond_id = -1;       ///< Which of the base's bonds: never the same twice.
  bool effective = true;       ///< False: the base stayed as it was; `note` says why.
  std::string note;            ///< E.g. "starts the base"; empty when there is nothing to say.
};

/// A fold over productions: base = base op shape. The base's free bonds are its own: after a
/// union or a morph those of both shapes less the two that were consumed; after a difference or an
/// intersection its own, and one on the new wall in place of the consumed one. Each is kept
/// on the surface as the base changes (moved along its line, or dropped when that misses). A side
/// without a free bond gets one computed from the grown base (bonds_of); where that would be a
/// consumed bond again, the support point; where that too is consumed, the production is not
/// effective.
///
/// The first shape starts the base whatever its operation says, because the empty shape minus,
/// intersected or morphed with anything would stay empty. A difference, intersection or
/// morph that would leave nothing is not effective either: it is recorded, with a note
/// and a warning, and the base stays.
class Growth {
 public:
  explicit Growth(Options options = {});

  /// Performs one production. Random choices (sides, bonds, turns) come from `key`.
  const Placement& apply(const ProductionStep& step, RandomKey key, int node = -1);

  const field::Field& field() const { return field_; }
  std::vector<Bond> free_bonds() const { return bonds_.free(); }
  const std::vector<Placement>& placements() const { return placements_; }
  const Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  void start(Shape shape, Placement& placement);
  void glue(const ProductionStep& step, Shape shape, RandomKey key, Placement& placement);
  /// Base and shape as the production has them; nothing when no solid would be left.
  std::optional<field::Field> combined(const ProductionStep& step, const Placement& placement,
                                       const Shape& shape) const;
  void grow(const ProductionStep& step, const Shape& shape, field::Field base,
            const Placement& placement);

  Options options_;
  field::Field field_;
  bool started_ = false;
  std::vector<field::Field> terms_;  ///< The base as one union, as long as unions follow.
  field::Blend terms_blend_;
  BondPool bonds_;
  std::vector<Placement> placements_;
  Diagnostics diagnostics_;
};

}  // namespace vug::sgm
