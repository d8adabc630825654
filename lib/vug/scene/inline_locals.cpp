// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/inline_locals.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::scene {

namespace {

/// Adds all names in the expression, bound ones included.
void collect_names(const Expr& expr, std::set<std::string>& names) {
  if (expr.kind == ExprKind::name) names.insert(expr.text);
  for (const Operand& part : expr.operands) collect_names(*part.value, names);
}

const Let* find_local(const std::vector<Let>& locals, const std::string& name) {
  const auto found = std::find_if(locals.begin(), locals.end(),
                                  [&](const Let& each) { return each.name == name; });
  return found == locals.end() ? nullptr : &*found;
}

}  // namespace

LocalInliner::LocalInliner(const std::vector<Let>& locals) {
  for (const Let& local : locals) collect_names(*local.value, occurring_);
  std::set<std::string> pending;
  for (const Let& local : locals) resolve(local, locals, pending);
}

/// Computes the value of a local after those that it uses.
void LocalInliner::resolve(const Let& local, const std::vector<Let>& all,
                           std::set<std::string>& pending) {
  if (values_.count(local.name) || !pending.insert(local.name).second) return;
  std::set<std::string> used;
  collect_names(*local.value, used);
  for (const std::string& name : used)
    if (const Let* other = find_local(all, name)) resolve(*other, all, pending);
  values_.emplace(local.name, replace(local.value, {}));
}

ExprPtr LocalInliner::operator()(const ExprPtr& expr) const {
  return expr && !values_.empty() ? replace(expr, {}) : expr;
}

/// `hidden`: the loop variables around the expression with their new names.
ExprPtr LocalInliner::replace(const ExprPtr& expr, const Substitution& hidden) const {
  if (expr->kind == ExprKind::name) {
    if (const auto bound = hidden.find(expr->text); bound != hidden.end()) {
      if (!bound->second) return expr;
      Expr renamed = *expr;
      renamed.text = bound->second->text;
      return std::make_shared<const Expr>(std::move(renamed));
    }
    const auto local = values_.find(expr->text);
    return local == values_.end() ? expr : local->second;
  }
  Expr made = *expr;
  Substitution inner = hidden;
  bool changed = false;
  made.depth = 1;
  for (Operand& part : made.operands) {
    const ExprPtr value = replace(part.value, inner);
    changed = changed || value != part.value;
    part.value = value;
    made.depth = std::max(made.depth, 1 + value->depth);
    for (Formal& bound : part.binds) {
      ExprPtr renamed;
      if (occurring_.count(bound.name)) {
        Expr name;
        name.kind = ExprKind::name;
        name.text = bound.name + "'";  // not a name of the language
        renamed = std::make_shared<const Expr>(std::move(name));
      }
      inner[bound.name] = renamed;
      if (!renamed) continue;
      bound.name = renamed->text;
      changed = true;
    }
  }
  return changed ? std::make_shared<const Expr>(std::move(made)) : expr;
}

namespace {

/// The full name of a called function, which may be that of a module.
std::string called_name(const Expr& call) {
  if (call.method && call.operands[0].value->kind == ExprKind::name)
    return full_name(*call.operands[0].value) + "." + call.text;
  return full_name(call);
}

/// The first draw in an expression; null if there is none. The range of a loop is not a draw.
const Expr* find_draw(const Expr& expr, const std::set<std::string>& drawing) {
  if (expr.kind == ExprKind::range) return &expr;
  if (expr.kind == ExprKind::call &&
      (expr.text == "pick" || drawing.count(called_name(expr)) || drawing.count(full_name(expr))))
    return &expr;
  for (const Operand& part : expr.operands) {
    const bool counts = part.name == "for" && part.value->kind == ExprKind::range;
    if (!counts) {
      if (const Expr* draw = find_draw(*part.value, drawing)) return draw;
      continue;
    }
    for (const Operand& end : part.value->operands)
      if (const Expr* draw = find_draw(*end.value, drawing)) return draw;
  }
  return nullptr;
}

bool is_drawing(const Def& def, const std::set<std::string>& drawing) {
  const auto draws = [&](const ExprPtr& expr) { return expr && find_draw(*expr, drawing); };
  return draws(def.body) ||
         std::any_of(def.formals.begin(), def.formals.end(),
                     [&](const Formal& formal) { return draws(formal.fallback); }) ||
         std::any_of(def.locals.begin(), def.locals.end(),
                     [&](const Let& local) { return draws(local.value); });
}

/// Sizes of expressions after the replacement, without making them.
class SizeChecker {
 public:
  SizeChecker(const std::vector<Let>& locals, Diagnostics& diagnostics)
      : locals_(locals), diagnostics_(diagnostics) {}

  struct Size {
    double operations = 0;
    int levels = 0;
  };

  Size of_local(const Let& local) {
    if (const auto known = known_.find(local.name); known != known_.end()) return known->second;
    if (std::find(pending_.begin(), pending_.end(), local.name) != pending_.end()) {
      diagnostics_.error(local.where, fmt::format("'{}' depends on itself", local.name));
      return known_[local.name] = {};
    }
    pending_.push_back(local.name);
    Size size = of(*local.value);
    pending_.pop_back();
    if (!known_.count(local.name)) known_[local.name] = checked(size, local.extent);
    return known_[local.name];
  }

  Size of(const Expr& expr) {
    if (expr.kind == ExprKind::name)
      if (const Let* local = find_local(locals_, expr.text)) return of_local(*local);
    Size size{1, 0};
    for (const Operand& part : expr.operands) {
      const Size inner = of(*part.value);
      size.operations += inner.operations;
      size.levels = std::max(size.levels, inner.levels);
    }
    ++size.levels;
    return size;
  }

  /// Reports a size that is too large; then returns that of a number.
  Size checked(const Size& size, const SourceLocation& where) {
    constexpr double kMaxOperations = 100'000;
    constexpr int kMaxLevels = 1000;
    if (size.operations <= kMaxOperations && size.levels <= kMaxLevels) return size;
    diagnostics_.error(
        where,
        size.levels > kMaxLevels
            ? fmt::format("the names of 'where' expand to more than {} levels", kMaxLevels)
            : fmt::format("the names of 'where' expand to more than {:.0f} operations",
                          kMaxOperations),
        "each use of a name in this rule repeats its expression");
    return {1, 1};
  }

 private:
  const std::vector<Let>& locals_;
  Diagnostics& diagnostics_;
  std::map<std::string, Size> known_;
  std::vector<std::string> pending_;
};

}  // namespace

std::set<std::string> drawing_functions(const std::vector<Def>& defs) {
  std::set<std::string> drawing;
  for (bool grows = true; grows;) {  // a function may be defined after its callers
    grows = false;
    for (const Def& def : defs)
      if (!drawing.count(def.name) && is_drawing(def, drawing))
        grows = drawing.insert(def.name).second;
  }
  return drawing;
}

void check_locals(const std::vector<Let>& locals, const std::vector<ExprPtr>& uses,
                  const std::set<std::string>& drawing, Diagnostics& diagnostics) {
  for (const Let& local : locals)
    if (const Expr* draw = find_draw(*local.value, drawing))
      diagnostics.error(draw->extent,
                        fmt::format("'{}' draws a random number, and each use of it would draw "
                                    "another one",
                                    local.name),
                        "pass it as a parameter of a symbol, or write the draw where it is used");
  SizeChecker sizes(locals, diagnostics);
  for (const Let& local : locals) sizes.of_local(local);
  SizeChecker::Size total;
  for (const ExprPtr& use : uses) {
    if (!use) continue;
    const SizeChecker::Size size = sizes.of(*use);
    total.operations += size.operations;
    total.levels = std::max(total.levels, size.levels);
  }
  sizes.checked(total, locals.front().extent.up_to(locals.back().extent));
}

}  // namespace vug::scene
