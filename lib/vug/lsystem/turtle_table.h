// SPDX-License-Identifier: Apache-2.0
// The list of all turtle commands.
#pragma once

#include <vug/lsystem/turtle.h>

namespace vug::lsystem {

enum class TurtleAction : uint8_t {
  nothing,
  draw,
  trace,
  move,
  left,
  right,
  down,
  up,
  roll_left,
  roll_right,
  back,
  level,
  width,
  colour,
  push,
  pop,
  open,
  corner,
  close,
  node,
  age,
  guide,
  elasticity,
  instance,
};

struct TurtleEntry {
  TurtleAction action;
  TurtleCommand command;
};
const std::vector<TurtleEntry>& turtle_table();

/// The turtle's action for a symbol of an alphabet; looked up once per word.
struct SymbolAction {
  TurtleAction type = TurtleAction::nothing;
  uint32_t name = 0;  ///< For instances: index in TurtleOptions::instances.
};
std::vector<SymbolAction> symbol_actions(const Alphabet& alphabet, const TurtleOptions& options);

}  // namespace vug::lsystem
