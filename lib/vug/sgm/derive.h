// SPDX-License-Identifier: Apache-2.0
// Derivation of a cave from a grammar, or from the paper's six parameters (zawadzki2012, section
// 2).
#pragma once

#include <vug/grammar/derive.h>
#include <vug/sgm/growth.h>
#include <vug/sgm/named_places.h>

namespace vug::sgm {

/// P_T = P_C + P_M (definition 3). Productions count whether or not they were effective.
struct Counts {
  int classic = 0;
  int morphic = 0;
  int total() const { return classic + morphic; }
};

struct DerivationResult {
  field::Field field;
  std::vector<Bond> bonds;  ///< The cave's free bonds.
  std::vector<Placement> operations;
  std::vector<NamedPlace> places;  ///< Places of effective steps that have a name.
  Counts counts;
  grammar::Tree tree;
  Diagnostics diagnostics;  ///< Warnings about productions without effect.
};

/// Performs the steps that the tree's leaves carry as payload (ProductionStep) in order. Other
/// leaves are unexpanded symbols and cause a warning, unless they carry a place (Transform). The
/// texts of leaves without effect get the reason: "+ sphere (left out: ...)".
DerivationResult interpret(grammar::Tree tree, const Options& options = {},
                           Progress& progress = Progress::none());

/// Derives and interprets.
DerivationResult derive(const grammar::Grammar& grammar, RandomKey key, const Options& options = {},
                        const grammar::Limits& limits = {}, Progress& progress = Progress::none());

/// A primitive available to the experiment.
struct ShapeChoice {
  std::string name;
  double weight = 1;
  std::function<field::Field(RandomKey)> make;  ///< E.g. with a random radius.
};

/// The paper's experiment (section 3). L_D, the sampling density, is a parameter of voxelisation.
struct Rules {
  std::vector<ShapeChoice> shapes;
  int classic = 10;                   ///< P_C
  int morphic = 2;                    ///< P_M, spread evenly among the classic productions.
  int pieces = 3;                     ///< P_S, primitives in a shape; 0 counts as 1.
  Label label = Label::plus_x;        ///< L_B
  Label piece_label = Label::random;  ///< Sides at which the pieces of a shape are joined.
  double amount = 0.52;               ///< M_P, ratio in 0..1.
  double unite = 4, subtract = 1, intersect = 1;  ///< Weights of the classic productions.
  field::Blend blend;
};

/// The experiment as a grammar: cave -> Classic... Morphic..., Classic -> + | - | &, Morphic -> ~.
/// Throws Error(bad_input) for invalid parameters.
grammar::Grammar grammar_of(const Rules& rules);

DerivationResult derive(const Rules& rules, RandomKey key, const Options& options = {},
                        const grammar::Limits& limits = {}, Progress& progress = Progress::none());

}  // namespace vug::sgm
