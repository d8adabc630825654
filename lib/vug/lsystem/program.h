// SPDX-License-Identifier: Apache-2.0
// Expressions of productions as programs for a small stack machine of doubles: compiled once, run
// for every module.
#pragma once

#include <cstdint>
#include <vector>

namespace vug::lsystem {

/// Booleans are 1 and 0. Binary operations take the second operand from the top of the stack.
enum class Op : uint8_t {
  constant,  ///< Pushes `value`.
  formal,    ///< Pushes formal number `index`.
  negate,
  opposite,  ///< Logical not.
  add,
  subtract,
  multiply,
  divide,
  power,
  less,
  less_equal,
  greater,
  greater_equal,
  equal,
  unequal,
  jump,          ///< To instruction `index`.
  jump_if_zero,  ///< Pops the top; jumps to `index` if it is 0.
  call1,         ///< Function `index` of one number.
  call2,
  call3,
  draw,          ///< Uniform between the two topmost, by random number `index`.
  choose,        ///< Pushes a uniform whole number in 0..value-1, by random number `index`.
  times_formal,  ///< Pushes formal `index` * `value`.
  plus_formal,   ///< Pushes formal `index` + `value`.
};

struct Instruction {
  Op op;
  uint32_t index = 0;
  double value = 0;
};

/// Functions of numbers; programs refer to them by their index in these lists.
struct Function1 {
  const char* name;
  double (*apply)(double);
};
struct Function2 {
  const char* name;
  double (*apply)(double, double);
};
struct Function3 {
  const char* name;
  double (*apply)(double, double, double);
};
const std::vector<Function1>& functions1();
const std::vector<Function2>& functions2();
const std::vector<Function3>& functions3();

/// Thrown by a run that compares with a non-finite number such as 1/0 or 0/0.
struct InvalidComparison {
  double value;
};

struct Program {
  std::vector<Instruction> code;
  int depth = 0;  ///< Maximum stack height.

  bool empty() const { return code.empty(); }
};

/// Runs the program on `stack`, which has a capacity of Program::depth numbers, and returns the end
/// of the results. `numbers` are the module's random numbers in [0, 1); see RandomNumbers. Throws
/// InvalidComparison.
double* run(const Program& program, const double* formals, double* stack, const double* numbers);

}  // namespace vug::lsystem
