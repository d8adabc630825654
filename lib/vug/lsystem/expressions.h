// SPDX-License-Identifier: Apache-2.0
// Compilation of scene expressions into programs.
#pragma once

#include <vug/lsystem/program.h>
#include <vug/scene/evaluator.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::lsystem {

/// Thrown after an error was added to the diagnostics.
struct AlreadyReported {};

/// Compiles the expressions of one production. Subexpressions without formals and random choices
/// are evaluated at once and may use the whole scene language; the others may use arithmetic,
/// comparisons, `if`, random choices and functions of numbers. Formals and results are in base
/// units and dimensionless.
class Expressions {
 public:
  Expressions(scene::Evaluator& evaluator, std::vector<std::string> formals)
      : evaluator_(evaluator), formals_(std::move(formals)) {}

  /// Appends code that pushes the number; throws AlreadyReported after an error.
  void number(const scene::Expr& expr, Program& program) { expect(expr, Type::number, program); }
  void truth(const scene::Expr& expr, Program& program) { expect(expr, Type::truth, program); }

  /// The value of a constant expression; nothing if it depends on the module.
  std::optional<Value> constant(const scene::Expr& expr);

  bool draws() const { return draws_; }  ///< Whether a compiled expression has a random choice.

 private:
  enum class Type { number, truth };

  void expect(const scene::Expr& expr, Type type, Program& program);
  Type compile(const scene::Expr& expr, Program& program);
  Type fold(const scene::Expr& expr, Program& program);
  Type unary(const scene::Expr& expr, Program& program);
  Type binary(const scene::Expr& expr, Program& program);
  Type logical(const scene::Expr& expr, Program& program);
  Type choose(const scene::Expr& expr, Program& program);
  Type pick(const scene::Expr& expr, Program& program);
  Type call(const scene::Expr& expr, Program& program);
  bool fuse(Program& program, Op op, size_t left, size_t right) const;
  bool is_constant(const scene::Expr& expr) const;
  std::optional<uint32_t> formal(const std::string& name) const;
  void put(Program& program, Op op, uint32_t index = 0, double value = 0);
  size_t jump(Program& program, Op op);
  void land(Program& program, size_t jump) const;
  [[noreturn]] void fail(const scene::Expr& expr, std::string message, std::string hint = {});

  scene::Evaluator& evaluator_;
  std::vector<std::string> formals_;
  bool draws_ = false;
  int height_ = 0;  ///< Stack height in the program that is being compiled.
};

}  // namespace vug::lsystem
