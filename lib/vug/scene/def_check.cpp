// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/def_check.h>
#include <vug/scene/resolver.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace vug::scene {

namespace {

class CallGraph {
 public:
  CallGraph(Document& document, Diagnostics& diagnostics) : diagnostics_(diagnostics) {
    for (Def& def : document.defs) defs_.emplace(def.name, Entry{&def});
  }

  void run() {
    for (auto& [name, entry] : defs_) visit(entry, entry.def->where);
  }

 private:
  struct Entry {
    Def* def;
    bool visited = false;
  };

  /// The calls and loop iterations of one call.
  double visit(Entry& entry, const SourceLocation& from) {
    Def& def = *entry.def;
    const auto first = std::find(chain_.begin(), chain_.end(), def.name);
    if (first != chain_.end()) {
      reject(from, fmt::format("the function '{}' calls itself", def.name),
             fmt::format("{} -> {}; only the rules of a grammar can be recursive",
                         fmt::join(first, chain_.end(), " -> "), def.name));
      return 1;
    }
    if (chain_.size() >= Resolver::kMaxPending) {
      reject(
          from,
          fmt::format("more than {} functions call each other in a chain", Resolver::kMaxPending),
          "");
      return 1;
    }
    if (entry.visited) return def.work;
    chain_.push_back(def.name);
    double work = 1 + work_of(*def.body);
    for (const Formal& formal : def.formals)
      if (formal.fallback) work += work_of(*formal.fallback);
    for (const Let& local : def.locals) work += work_of(*local.value);
    chain_.pop_back();
    entry.visited = true;
    def.work = work;
    return work;
  }

  /// Removes the body of the innermost function, so that it is never called.
  void reject(const SourceLocation& where, const std::string& message, const std::string& hint) {
    diagnostics_.error(where, message, hint);
    Def& def = *defs_.at(chain_.back()).def;
    Expr broken;
    broken.kind = ExprKind::broken;
    broken.extent = broken.where = def.body->extent;
    rejected_.push_back(std::exchange(def.body, std::make_shared<const Expr>(std::move(broken))));
  }

  /// Beyond the depth, evaluation reports "values are nested too deeply" in any case.
  double work_of(const Expr& expr) {
    constexpr int kMaxDepth = 2000;
    if (depth_ > kMaxDepth) return 0;
    ++depth_;
    const double work = work_of_node(expr);
    --depth_;
    return work;
  }

  double work_of_node(const Expr& expr) {
    if (expr.kind == ExprKind::comprehension) return work_of_loop(expr, 0);
    double work = 0;
    if (expr.kind == ExprKind::call && expr.text == "if" && expr.operands.size() == 3) {
      const double yes = work_of(*expr.operands[1].value), no = work_of(*expr.operands[2].value);
      return work_of(*expr.operands[0].value) + std::max(yes, no);
    }
    for (const Operand& part : expr.operands) work += work_of(*part.value);
    if (expr.kind == ExprKind::call)
      if (const auto called = find(expr); called != defs_.end())
        work += visit(called->second, word_at(expr.where, expr.text));
    return work;
  }

  /// The called function, which may be that of a module.
  std::map<std::string, Entry>::iterator find(const Expr& call) {
    if (call.method && call.operands[0].value->kind == ExprKind::name) {
      const std::string module = full_name(*call.operands[0].value);
      if (const auto other = defs_.find(module + "." + call.text); other != defs_.end())
        return other;
    }
    return defs_.find(full_name(call));
  }

  double work_of_loop(const Expr& loop, size_t clause) {
    if (clause >= loop.operands.size()) return 0;
    const Operand& here = loop.operands[clause];
    const double inner = work_of_loop(loop, clause + 1);
    return work_of(*here.value) +
           (here.name == "for" ? length_of(*here.value) * (1 + inner) : inner);
  }

  /// The number of elements, if the text determines it; else 1.
  static double length_of(const Expr& list) {
    if (list.kind == ExprKind::list) return static_cast<double>(list.operands.size());
    if (list.kind != ExprKind::range) return 1;
    const Expr& low = *list.operands[0].value;
    const Expr& high = *list.operands[1].value;
    if (low.kind != ExprKind::number || high.kind != ExprKind::number) return 1;
    return std::max(0.0, high.number.value - low.number.value + 1);
  }

  Diagnostics& diagnostics_;
  std::map<std::string, Entry> defs_;
  std::vector<std::string> chain_;
  int depth_ = 0;
  std::vector<ExprPtr> rejected_;  ///< Bodies that may still be visited.
};

}  // namespace

void check_calls(Document& document, Diagnostics& diagnostics) {
  CallGraph(document, diagnostics).run();
}

}  // namespace vug::scene
