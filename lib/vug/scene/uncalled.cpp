// SPDX-License-Identifier: Apache-2.0
// Names in the functions that nothing has called, and whose bodies are therefore never evaluated.
#include <vug/scene/evaluator.h>
#include <vug/scene/functions.h>
#include <vug/scene/units.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::scene {

namespace {

/// Visits the names and calls of a function that it does not bind itself.
template <class Visit>
class FreeNames {
 public:
  explicit FreeNames(const Visit& visit) : visit_(visit) {}

  void add(const Def& def) {
    for (const Formal& formal : def.formals) {
      if (formal.fallback) add(*formal.fallback);
      bound_.push_back(formal.name);
    }
    for (const Let& local : def.locals) bound_.push_back(local.name);
    for (const Let& local : def.locals) add(*local.value);
    add(*def.body);
  }

 private:
  void add(const Expr& expr) {
    const bool is_bound = std::find(bound_.begin(), bound_.end(), expr.text) != bound_.end();
    if (expr.kind == ExprKind::call || (expr.kind == ExprKind::name && !is_bound))
      visit_(expr, bound_);
    const size_t outer = bound_.size();
    for (const Operand& part : expr.operands) {
      add(*part.value);
      for (const Formal& bound : part.binds) bound_.push_back(bound.name);
    }
    bound_.resize(outer);
  }

  const Visit& visit_;
  std::vector<std::string> bound_;
};

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_constant_name(const std::string& name) {
  return name == "pi" || name == "frame" || name == "X" || name == "Y" || name == "Z" ||
         is_unit(name);
}

}  // namespace

void Evaluator::check_uncalled() {
  const std::vector<std::string> names = resolver_.known_names(), calls = resolver_.known_calls();
  const auto check = [&](const Expr& expr, const std::vector<std::string>& bound) {
    const std::string full = full_name(expr);
    if (document_.skipped.may_declare(expr.text)) return;
    if (expr.kind == ExprKind::name) {
      const bool known = globals_.count(full) || contains(names, full) ||
                         document_.find_module(full) || is_constant_name(expr.text) ||
                         resolver_.is_word(expr.text);
      if (!known)
        site(expr).fault(fmt::format("unknown name '{}'", expr.text),
                         did_you_mean(expr.text, bound, name_hint(expr.text)));
      return;
    }
    const bool known = defs_.count(full) || globals_.count(full) || find_function(expr.text) ||
                       contains(calls, expr.text) || expr.text == "if" || expr.text == "pick" ||
                       expr.text == "keys" || is_module_call(expr);
    if (!known) report_unknown_function(expr);
  };
  for (const Def& def : document_.defs) {
    const bool own = !document_.sources.empty() && def.where.file == document_.sources[0]->file;
    if (own && !def.broken && !called_.count(def.name)) FreeNames(check).add(def);
  }
}

}  // namespace vug::scene
