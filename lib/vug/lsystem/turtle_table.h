// The one list of what a turtle understands.
#pragma once

#include <vug/lsystem/turtle.h>

namespace vug::lsystem {

enum class Turn : uint8_t {
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
  Turn turn;
  TurtleCommand command;
};
const std::vector<TurtleEntry>& turtle_table();

/// What a symbol of an alphabet means: looked up once for each word.
struct Meaning {
  Turn turn = Turn::nothing;
  uint32_t name = 0;  ///< Of an instance: index into the options' list.
};
std::vector<Meaning> meanings(const Alphabet& alphabet, const TurtleOptions& options);

}  // namespace vug::lsystem
