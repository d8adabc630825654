// SPDX-License-Identifier: Apache-2.0
// The base shape under a sequence of productions, with the default overlap of each operation.
#pragma once

#include <vug/base/box_index.h>
#include <vug/base/diagnostics.h>
#include <vug/sgm/bond_pool.h>
#include <vug/sgm/geology.h>
#include <vug/sgm/production_step.h>

namespace vug::sgm {

struct Options {
  /// The depth to which a glued shape is pressed into the base against the label's direction, as a
  /// fraction of its extent. 0: the walls touch, as in definition 5; 0.5: its centre coincides with
  /// the bond; 1: it lies inside with its far wall on the base's wall.
  struct Overlap {
    double unite = 0.3;       ///< Round walls that merely touch would leave no passage.
    double subtract = 0.3;    ///< A niche; deeper ones sever thin ends more often.
    double intersect = 0.75;  ///< The base's end takes the form of the outer half of the shape.
    double morph = 0.5;  ///< Solids that are further apart than their radii have no morph at 50 %.
    double of(Operation operation) const;
  } overlap;
  Reach reach = Reach::local;
  Geology geology;
};

/// A record of one performed production.
struct Placement {
  Operation operation = Operation::unite;
  std::string shape;           ///< Name of the (compound) shape.
  std::string name;            ///< The name of the place; may be empty.
  int node = -1;               ///< Leaf of the derivation tree; -1 without a tree.
  Label side = Label::plus_x;  ///< The side of the base it was glued to.
  Transform map;               ///< From the shape's own space to its final position.
  field::Field field;          ///< The shape at its final position.
  double amount = 0;           ///< Amount of a morph, after the adjustment by the geology.
  double press = 0;       ///< Distance by which it was pressed in after the label was made, metres.
  Vec3d heading{0.0};     ///< The direction in which it continues the base, a unit vector; 0: none.
  bool in_frame = false;  ///< It was placed in a frame instead of being glued.
  int owner = -1;         ///< Index of the placement to which it was glued; -1: none.
  int other_end = -1;     ///< The placement that a connecting shape joins to `owner`; -1: none.
  bool glued = false;     ///< base_bond and shape_bond made a label (before pressing).
  Bond base_bond, shape_bond;  ///< Both are consumed. Undefined unless glued.
  int base_bond_id = -1;       ///< Unique number of the base's bond.
  bool effective = true;       ///< False: the base is unchanged; `note` gives the reason.
  bool refused = false;        ///< Not effective because of the step's limits.
  std::string note;            ///< E.g. "starts the base"; may be empty.

  /// The middle of the shape's bounds, or the origin of its map if these are infinite.
  Vec3d middle() const;
};

/// A fold over productions: base = base op shape. The base has its own free bonds: after a union or
/// a morph, those of both shapes without the two consumed ones; after a difference or an
/// intersection, its own ones, with one on the new wall in place of the consumed one. Each bond is
/// kept on the surface as the base changes (moved along its line, or dropped if that misses). A
/// side without a free bond gets one computed from the grown base (bonds_of); if that bond is
/// already consumed, the support point; if that is consumed too, the production is not effective.
///
/// The first shape starts the base whatever its operation is, because a difference, intersection or
/// morph with the empty shape would be empty. A difference, intersection or morph that would leave
/// nothing is not effective either: it is recorded with a note and a warning, and the base remains
/// unchanged. A production that breaks its step's limits is recorded with a note only.
///
/// Steps with a frame are not glued: their shapes are placed, and get and consume no bonds. They
/// take effect together, before the next glued production. They keep apart from each other, whether
/// they are added or cut, but not from the solid that they dress. Steps that connect two places are
/// placed, too: their shapes extend from the middle of the last placement with the first name to
/// that with the second; if the names are equal, from the last but one to the last. They are
/// refused if one of these was refused, and not effective without these.
class Growth {
 public:
  explicit Growth(Options options = {});

  /// Performs one production. Random choices (sides, bonds, rotations) derive from `key`.
  const Placement& apply(const ProductionStep& step, RandomKey key, int node = -1);

  /// The base after all productions.
  const field::Field& field();
  std::vector<Bond> free_bonds() const { return bonds_.free(); }
  const std::vector<Placement>& placements() const { return placements_; }
  const Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  void start(Shape shape, Placement& placement);
  void glue(const ProductionStep& step, Shape shape, RandomKey key, Placement& placement);
  void place(const ProductionStep& step, const Shape& shape, Placement& placement);
  void place_in_frame(const ProductionStep& step, const Shape& shape, Placement& placement);
  void connect(const ProductionStep& step, const Shape& shape, Placement& placement);
  /// Index of the last placement of a name before index `before`; -1: none.
  int last_named(const std::string& name, size_t before) const;
  /// Performs the productions that wait for others of the same operation and blend.
  void flush();
  /// Whether the step's limits exclude the placement.
  bool is_refused(const ProductionStep& step, Placement& placement) const;
  /// The result of the production; nothing if no solid would remain.
  std::optional<field::Field> combined(const ProductionStep& step, const Placement& placement,
                                       const Shape& shape) const;
  void grow(const ProductionStep& step, const Shape& shape, field::Field base,
            const Placement& placement);

  Options options_;
  field::Field field_;
  bool started_ = false;
  std::vector<field::Field> terms_;  ///< The operands of the base as long as it is a single union.
  field::Blend terms_blend_;
  /// Placed shapes that are not yet part of the base.
  struct Waiting {
    Operation operation = Operation::unite;
    field::Blend blend;
    std::vector<field::Field> shapes;
  } waiting_;
  BondPool bonds_;
  std::vector<Placement> placements_;
  BoxIndex boxes_;        ///< Boxes of the placements whose shapes the base contains.
  BoxIndex frame_boxes_;  ///< Boxes of the placements in a frame.
  Diagnostics diagnostics_;
};

}  // namespace vug::sgm
