// SPDX-License-Identifier: Apache-2.0
// One production of an SG+M derivation, the payload of the leaves of its tree.
#pragma once

#include <vug/base/error.h>
#include <vug/field/blend.h>
#include <vug/sgm/heading.h>
#include <vug/sgm/shape.h>

#include <utility>

namespace vug::sgm {

enum class Operation { unite, subtract, intersect, morph };

/// "union", "difference", "intersection", "morph".
std::string to_string(Operation operation);
/// "+", "-", "&", "~", as written in scenes.
std::string sign_of(Operation operation);

/// The extent of a production's effect.
enum class Reach {
  local,  ///< Near the new shape; the rest of the base is unchanged. See region.h.
  whole,  ///< Everywhere, as in the paper's equations (2) to (5).
};

/// A production whose shape would break a limit has no effect, without a warning.
struct Limits {
  std::optional<field::Field> within;  ///< The middle of the shape must lie inside.
  /// Least distance in metres to earlier shapes, except those in a chain of at most two bonds; of a
  /// shape in a frame, to earlier ones in frames. It is tested at the middle of the shape and at 26
  /// points of its surface.
  double apart = 0;
};

/// A primitive (or any field) added by a step.
struct Piece {
  std::string name;
  field::Field field;
};

struct ProductionStep {
  Operation operation = Operation::unite;
  std::vector<Piece> pieces;  ///< At least one; several are first glued to a compound shape (P_S).
  Label piece_label = Label::random;  ///< Side at which each piece is glued to the previous ones.
  Label label = Label::random;        ///< L_B: the side of the base to glue to.
  double amount = 0.5;                ///< M_P as a ratio in 0..1; for morphs.
  field::Blend blend;                 ///< Blend between the new shape and the base.
  std::optional<double> overlap;      ///< See Options::overlap; empty: the operation's default.
  std::optional<Reach> reach;         ///< Empty: Options::reach.
  /// The place of the shape, from its own space to the base's, e.g. a leg of a network; empty: it
  /// is glued to the base.
  std::optional<Transform> frame;
  std::string name;  ///< The name of the place where the shape is; empty: none.
  Heading heading;   ///< Turns a glued shape.
  Limits limits;     ///< Where the shape may be.
  /// The names of the two places that the shape connects, instead of being glued or placed.
  std::optional<std::pair<std::string, std::string>> connect;
  SourceLocation where;  ///< Source location for messages.
};

}  // namespace vug::sgm
