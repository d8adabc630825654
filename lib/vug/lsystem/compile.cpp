// SPDX-License-Identifier: Apache-2.0
#include <vug/lsystem/compile.h>
#include <vug/lsystem/expressions.h>
#include <vug/lsystem/nontermination.h>
#include <vug/lsystem/production_selector.h>
#include <vug/lsystem/rule_book.h>
#include <vug/lsystem/unreachable_rules.h>
#include <vug/scene/inline_locals.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vug::lsystem {

namespace {

constexpr const char* kRotations = "+-&^\\/";

class Compiler {
 public:
  Compiler(const scene::Grammar& grammar, const SystemOptions& options, scene::Evaluator& evaluator,
           const FindSystem& find)
      : grammar_(grammar),
        text_(*grammar.lsystem),
        options_(options),
        evaluator_(evaluator),
        find_(find) {}

  SystemPtr run() {
    system_.name = grammar_.name;
    system_.where = grammar_.where;
    system_.key = evaluator_.root().at("grammar").at(grammar_.name).state();
    options();
    run_guarded([&] { axiom(); });
    compile_rules();
    if (faults_) return nullptr;
    classify_symbols();
    run_guarded([&] { subsystems(); });
    finish_books();
    if (faults_ || !check_termination(system_, evaluator_.diagnostics())) return nullptr;
    return std::make_shared<const System>(std::move(system_));
  }

 private:
  template <class Work>
  void run_guarded(const Work& work) {
    try {
      work();
    } catch (const AlreadyReported&) {
      faults_ = true;
    }
  }

  [[noreturn]] void fail(const SourceLocation& where, std::string message, std::string hint = {}) {
    evaluator_.diagnostics().error(where, std::move(message), std::move(hint));
    throw AlreadyReported{};
  }

  void options() {
    system_.steps = options_.steps;
    system_.time = options_.time;
    system_.limit = static_cast<int64_t>(options_.limit);
    if (options_.seed)
      system_.key =
          RandomKey(static_cast<uint64_t>(*options_.seed)).at("grammar").at(grammar_.name).state();
  }

  /// The location at which the block sets the option; unknown if it does not.
  SourceLocation where_set(const char* option) const {
    for (const scene::Entry& entry : grammar_.options)
      if (entry.key == option) return entry.where;
    return {};
  }

  void axiom() {
    Production& axiom = system_.axiom;
    axiom.text = "axiom";
    axiom.where = grammar_.axiom_where;
    Expressions expressions(evaluator_, {});
    word(text_.axiom, scene::LocalInliner({}), expressions, axiom);
    system_.random = system_.random || expressions.draws();
  }

  void word(const scene::ModuleString& modules, const scene::LocalInliner& inlined,
            Expressions& expressions, Production& out) {
    for (const scene::Module& module : modules) {
      out.symbols.push_back(symbol(module.name, module.arguments.size(), module.where));
      for (const scene::ExprPtr& given : module.arguments) {
        const scene::ExprPtr argument = inlined(given);
        if (given == module.arguments[0] && is_rotation(module.name))
          check_rotation(*argument, expressions);
        expressions.number(*argument, out.values);
      }
      const uint32_t before = out.ends.empty() ? 0 : out.ends.back();
      out.ends.push_back(before + static_cast<uint32_t>(module.arguments.size()));
    }
    out.in_place = static_cast<size_t>(out.values.depth) <= out.value_count();
    out.simple = out.values.code.size() == out.value_count() &&
                 std::all_of(out.values.code.begin(), out.values.code.end(), [](const auto& one) {
                   return one.op == Op::constant || one.op == Op::formal ||
                          one.op == Op::times_formal || one.op == Op::plus_formal;
                 });
  }

  static bool is_rotation(const std::string& name) {
    return name.size() == 1 && std::string_view(kRotations).find(name[0]) != std::string_view::npos;
  }

  /// Rejects plain numbers as angles: +(60) would be sixty radians.
  void check_rotation(const scene::Expr& argument, Expressions& expressions) {
    const std::optional<Value> value = expressions.constant(argument);
    const Number* n = value ? value->get<Number>() : nullptr;
    if (n && n->value != 0 && n->dimension != Dimension::angle)
      fail(argument.where,
           fmt::format("a rotation by {}: an angle needs a unit", to_string(*value)),
           fmt::format("write {0}deg or {0}rad", n->value));
  }

  SymbolId symbol(const std::string& name, size_t parameters, const SourceLocation& where) {
    try {
      return system_.alphabet.add(name, parameters);
    } catch (const Error& error) {
      fail(where, error.what(), error.hint());
    }
  }

  std::vector<ContextModule> context(const std::vector<scene::Pattern>& patterns) {
    std::vector<ContextModule> out;
    for (const scene::Pattern& one : patterns) {
      ContextModule module;
      if (one.name == "[") module.kind = ContextModule::Kind::open;
      if (one.name == "]") module.kind = ContextModule::Kind::close;
      module.symbol = symbol(one.name, one.formals.size(), one.where);
      out.push_back(module);
    }
    return out;
  }

  static std::string head_text(const scene::Pattern& pattern) {
    std::string out = pattern.name;
    for (size_t i = 0; i < pattern.formals.size(); ++i)
      out += fmt::format("{}{}", i == 0 ? "(" : ", ", pattern.formals[i].name);
    return pattern.formals.empty() ? out : out + ')';
  }

  void production(const scene::Production& text, bool stage) {
    Production out;
    out.text = head_text(text.head);
    out.where = text.extent;
    out.head = symbol(text.head.name, text.head.formals.size(), text.head.where);
    std::vector<std::string> formals;
    const auto add = [&](const scene::Pattern& pattern) {
      for (const scene::Formal& formal : pattern.formals) formals.push_back(formal.name);
    };
    std::for_each(text.left.begin(), text.left.end(), add);
    add(text.head);
    std::for_each(text.right.begin(), text.right.end(), add);
    out.left = context(text.left);
    out.right = context(text.right);
    if (stage && out.has_context())
      fail(out.where, "rules of a stage cannot have a context",
           "contexts are only allowed in rules outside of 'decompose' and 'interpret'");
    if (text.after) {
      if (text.head.formals.empty())
        fail(text.after->where, fmt::format("'{}' has no parameter for its age", out.text),
             fmt::format("write {}(age) after ...", text.head.name));
      if (out.has_context() || stage)
        fail(text.after->where, "'after' cannot be combined with a context or a stage");
    }
    Expressions expressions(evaluator_, formals);
    const scene::LocalInliner inlined(text.locals);
    if (text.guard) expressions.truth(*inlined(text.guard), out.guard);
    if (text.weight) weight(*inlined(text.weight), expressions, out.weight);
    if (text.after) expressions.number(*inlined(text.after), out.after);
    word(text.word, inlined, expressions, out);
    if (expressions.draws() || text.weight) system_.random = true;
    if (system_.productions.size() >= 65000) fail(out.where, "more than 65000 rules");
    system_.productions.push_back(std::move(out));
    if (text.after) aged_.insert(system_.productions.back().head);
  }

  void weight(const scene::Expr& text, Expressions& expressions, Program& out) {
    expressions.number(text, out);
    const Instruction& only = out.code.front();
    if (out.code.size() == 1 && only.op == Op::constant && only.value < 0)
      fail(text.where, fmt::format("invalid weight {}", only.value), kWeights);
  }

  std::vector<uint16_t> productions(const std::vector<scene::Production>& texts, bool stage) {
    std::vector<uint16_t> indices;
    for (const scene::Production& text : texts)
      run_guarded([&] {
        production(text, stage);
        indices.push_back(static_cast<uint16_t>(system_.productions.size() - 1));
      });
    return indices;
  }

  void compile_rules() {
    const std::vector<uint16_t> always = productions(text_.productions, false);
    for (const scene::ProductionTable& table : text_.tables) {
      pending_.push_back(productions(table.productions, false));
      pending_.back().insert(pending_.back().end(), always.begin(), always.end());
    }
    if (text_.tables.empty()) pending_.push_back(always);
    decompose_ = productions(text_.decompose.productions, true);
    interpret_ = productions(text_.interpret.productions, true);
    run_guarded([&] { schedule(); });
    for (auto [stage, text] : {std::pair(&system_.decompose, &text_.decompose),
                               std::pair(&system_.interpret, &text_.interpret)})
      run_guarded([&, out = stage, depth = text->depth] {
        if (!depth) return;
        const auto count = evaluator_.count(*depth, evaluator_.root().at("depth"));
        if (!count) throw AlreadyReported{};
        out->depth = *count;
      });
  }

  void schedule() {
    for (const scene::ScheduleTurn& turn : text_.schedule) {
      std::optional<int> count = 1;
      if (turn.count) count = evaluator_.count(*turn.count, evaluator_.root().at("schedule"));
      if (!count) throw AlreadyReported{};
      if (system_.schedule.size() + static_cast<size_t>(*count) > 1'000'000)
        fail(turn.where, "the schedule has more than a million steps");
      const auto table = std::find_if(text_.tables.begin(), text_.tables.end(),
                                      [&](const auto& one) { return one.name == turn.table; });
      system_.schedule.insert(system_.schedule.end(), static_cast<size_t>(*count),
                              static_cast<uint16_t>(table - text_.tables.begin()));
    }
    if (system_.schedule.empty() && !text_.schedule.empty())
      fail(text_.schedule[0].where, "the schedule has no steps",
           "at least one table must have a count above 0");
    if (system_.schedule.empty()) system_.schedule.push_back(0);
  }

  bool contains(const std::vector<scene::Pattern>& list, const std::string& name) const {
    return std::any_of(list.begin(), list.end(), [&](const auto& one) { return one.name == name; });
  }

  /// Sets the properties of symbols: brackets, cuts, ignored symbols, ages, queries.
  void classify_symbols() {
    Alphabet& alphabet = system_.alphabet;
    system_.open = alphabet.find("[", 0);
    system_.close = alphabet.find("]", 0);
    system_.cut = alphabet.find("%", 0);
    for (size_t i = 0; i < alphabet.size(); ++i) {
      const auto id = static_cast<SymbolId>(i);
      const std::string& name = alphabet.name(id);
      const bool bracket = id == system_.open || id == system_.close;
      system_.ignored.push_back(!bracket &&
                                (contains(text_.ignore, name) ||
                                 (!text_.consider.empty() && !contains(text_.consider, name))));
      system_.ages.push_back(alphabet.parameters(id) > 0 &&
                             (aged_.count(id) > 0 || contains(text_.ages, name)));
      system_.query.push_back(System::is_query(name));
      system_.has_queries = system_.has_queries || System::is_query(name);
    }
    system_.timed = std::find(system_.ages.begin(), system_.ages.end(), true) != system_.ages.end();
    for (Production& p : system_.productions)
      for (size_t k = 0; k < p.symbols.size(); ++k)
        if (system_.ages[p.symbols[k]]) p.ages.push_back(k == 0 ? 0 : p.ends[k - 1]);
    run_guarded([&] {
      if (const SourceLocation steps = where_set("steps"); system_.timed && steps.known())
        fail(steps, "a system whose modules age has a 'time' instead of 'steps'");
      if (const SourceLocation time = where_set("time"); !system_.timed && time.known())
        fail(time, "'time' requires modules that age",
             "give their rules an 'after', or name them in 'ages'");
      if (!system_.timed) return;
      for (const Production& p : system_.productions)
        if (p.has_context()) fail(p.where, "if modules age, rules cannot have a context");
      if (text_.schedule.size() > 1)
        fail(text_.schedule[1].where, "if modules age, there can be only one table");
      const std::vector<uint16_t>& book = pending_[0];
      for (const uint16_t rule : book) {
        const Production& p = system_.productions[rule];
        if (p.after.empty())
          fail(p.where, fmt::format("the rule of '{}' has no 'after'", p.text),
               "if modules age, every rule needs an 'after'; move others to 'decompose'");
      }
    });
  }

  void subsystems() {
    const size_t own = system_.alphabet.size();
    std::set<SymbolId> heads;
    for (const Production& p : system_.productions) heads.insert(p.head);
    for (size_t i = 0; i < own; ++i) {
      const auto id = static_cast<SymbolId>(i);
      const std::string name = system_.alphabet.name(id);
      if (heads.count(id) || system_.alphabet.parameters(id) > 1 || scene::is_turtle_name(name))
        continue;
      const SystemPtr inner = find_(name, grammar_.where);
      if (!inner) continue;
      SubSystem sub{inner, {}};
      for (size_t s = 0; s < inner->alphabet.size(); ++s) {
        const auto theirs = static_cast<SymbolId>(s);
        sub.symbols.push_back(symbol(inner->alphabet.name(theirs),
                                     inner->alphabet.parameters(theirs), grammar_.where));
      }
      system_.random = system_.random || inner->random;
      system_.subsystems.emplace(id, std::move(sub));
    }
    // Symbols added by subsystems are constants in this system.
    for (size_t i = own; i < system_.alphabet.size(); ++i) {
      system_.ignored.push_back(false);
      system_.ages.push_back(false);
      system_.query.push_back(false);
    }
  }

  RuleBook book(const std::vector<uint16_t>& indices) {
    RuleBook out = rule_book(system_, indices);
    warn_unreachable_rules(system_, out, evaluator_.diagnostics(), warned_);
    return out;
  }

  void finish_books() {
    number_draws(system_);
    for (const std::vector<uint16_t>& indices : pending_) system_.books.push_back(book(indices));
    system_.decompose.book = book(decompose_);
    system_.interpret.book = book(interpret_);
  }

  const scene::Grammar& grammar_;
  const scene::LSystem& text_;
  const SystemOptions& options_;
  scene::Evaluator& evaluator_;
  const FindSystem& find_;
  System system_;
  std::vector<std::vector<uint16_t>> pending_;  ///< Rules of each table.
  std::vector<uint16_t> decompose_, interpret_;
  std::set<SymbolId> aged_;
  std::set<uint16_t> warned_;
  bool faults_ = false;
};

}  // namespace

SystemPtr compile(const scene::Grammar& grammar, const SystemOptions& options,
                  scene::Evaluator& evaluator, const FindSystem& find) {
  return Compiler(grammar, options, evaluator, find).run();
}

SystemPtr compile(const scene::Grammar& grammar, scene::Evaluator& evaluator,
                  const FindSystem& find) {
  const std::optional<SystemOptions> options = system_options(grammar, evaluator);
  const SystemPtr made = compile(grammar, options.value_or(SystemOptions()), evaluator, find);
  return options ? made : nullptr;
}

}  // namespace vug::lsystem
