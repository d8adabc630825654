// One production of an SG+M derivation: what the leaves of its tree carry as payload.
#pragma once

#include <vug/base/error.h>
#include <vug/field/blend.h>
#include <vug/sgm/shape.h>

namespace vug::sgm {

enum class Operation { unite, subtract, intersect, morph };

/// "union", "difference", "intersection", "morph".
std::string to_string(Operation operation);
/// "+", "-", "&", "~": how scenes write it.
std::string sign_of(Operation operation);

/// How far a production's effect goes.
enum class Reach {
  local,  ///< Where the new shape is; the rest of the base stays. See region.h.
  whole,  ///< Everywhere, as the paper's equations (2) to (5) stand.
};

/// A primitive (or any field) that a step brings.
struct Piece {
  std::string name;
  field::Field field;
};

struct ProductionStep {
  Operation operation = Operation::unite;
  std::vector<Piece> pieces;  ///< At least one; more are glued to a compound shape (P_S) first.
  Label piece_label = Label::random;  ///< Where each piece is glued to those before it.
  Label label = Label::random;        ///< L_B: the side of the base to glue to.
  double amount = 0.5;                ///< M_P as a ratio in 0..1; for morphs.
  field::Blend blend;                 ///< How the new shape meets the base.
  std::optional<double> overlap;      ///< See Options::overlap; empty: the operation's default.
  std::optional<Reach> reach;         ///< Empty: Options::reach.
  SourceLocation where;               ///< In the user's text, for messages.
};

}  // namespace vug::sgm
