// Expressions of productions as a small program over a stack of doubles: compiled once, run for
// every module.
#pragma once

#include <cstdint>
#include <vector>

namespace vug::lsystem {

/// Truths are 1 and 0. Two-sided operations take the second operand from the top of the stack.
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
  jump_if_zero,  ///< Takes the top; jumps to `index` if it is 0.
  call1,         ///< Function `index` of one number.
  call2,
  call3,
  draw,          ///< Between the two topmost, evenly, by random number `index`.
  choose,        ///< Pushes a whole number in 0..value-1, evenly, by random number `index`.
  times_formal,  ///< Pushes formal `index` * `value`.
  plus_formal,   ///< Pushes formal `index` + `value`.
};

struct Instruction {
  Op op;
  uint32_t index = 0;
  double value = 0;
};

/// Functions of numbers that programs call by their place in these lists.
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

/// What a run ends with that compares with a number which is none: 1/0, 0/0.
struct InvalidComparison {
  double value;
};

struct Program {
  std::vector<Instruction> code;
  int depth = 0;  ///< Most numbers on the stack at once.

  bool empty() const { return code.empty(); }
};

/// Runs the program; what it leaves on the stack begins at `stack`, and the end of it is returned.
/// `stack` has room for Program::depth numbers. `numbers` are the module's random ones, in [0, 1);
/// see RandomNumbers. Throws InvalidComparison.
double* run(const Program& program, const double* formals, double* stack, const double* numbers);

}  // namespace vug::lsystem
