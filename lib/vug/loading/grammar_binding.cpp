// SPDX-License-Identifier: Apache-2.0
// Converts scene rules to productions whose callables evaluate expressions of the scene. The leaves
// contain SG+M steps, which sgm::interpret performs.
#include <vug/field/kind.h>
#include <vug/field/material_source.h>
#include <vug/loading/facade_binding.h>
#include <vug/loading/grammar_binding.h>
#include <vug/loading/item_clauses.h>
#include <vug/loading/lsystem_binding.h>
#include <vug/loading/network_symbols.h>
#include <vug/sgm/derive.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace vug::loading {
namespace {

bool has_rule(const scene::Grammar& grammar, const std::string& symbol) {
  return std::any_of(grammar.rules.begin(), grammar.rules.end(),
                     [&](const scene::Rule& rule) { return rule.head == symbol; });
}

class Binder {
 public:
  Binder(const scene::Grammar& grammar, ReadContext& context)
      : source_(grammar),
        evaluator_(context.evaluator),
        resolver_(context.resolver),
        values_(context),
        key_(evaluator_.root().at("grammar").at(grammar.name)) {}

  grammar::Grammar bind();
  RandomKey key() const { return key_; }
  /// An option of the grammar block that is a whole number of at least 1; default: `fallback`.
  int64_t limit(const std::string& option, int64_t fallback);
  sgm::Options options();

 private:
  grammar::SuccessorItem part(const scene::Item& item, const scene::Rule& rule);
  grammar::Content step(const scene::Item& item, const scene::Rule& rule,
                        const grammar::RewriteSite& site);
  std::vector<sgm::Piece> pieces(const scene::Item& item, int count, const scene::Scope& scope,
                                 RandomKey key);
  /// Reads the option `dress` and the attributes that the rules use.
  void read_network();
  /// Reports items that would make elements of the network.
  void refuse_elements(const std::vector<scene::Item>& items) const;
  /// The item of the axiom that makes a symbol for each element of the network.
  grammar::SuccessorItem elements_part(const NetworkSymbol& symbol) const;
  /// The symbol of the network that the rule rewrites, or null.
  const NetworkSymbol* element_symbol(const std::string& name) const {
    return network_ ? find_network_symbol(name) : nullptr;
  }
  RuleScope scope_of(const scene::Rule& rule, const grammar::RewriteSite& site) const {
    const auto order = orders_.find(&rule);
    return RuleScope(rule, site, order == orders_.end() ? nullptr : &order->second);
  }

  const scene::Grammar& source_;
  scene::Evaluator& evaluator_;
  Resolver& resolver_;
  RuleValues values_;
  RandomKey key_;
  shot::NetworkPtr network_;  ///< The network that the grammar dresses; may be null.
  /// By rule of a network symbol: the attributes that its parameters name.
  std::map<const scene::Rule*, std::vector<size_t>> orders_;
};

std::vector<std::string> option_names() {
  std::vector<std::string> names;
  for (const ParamInfo& option : grammar_info().params) names.push_back(option.name);
  return names;
}

/// The shape's own name, below the transforms that place it.
std::string shape_name(const field::Node& node) {
  static const std::set<std::string> placing = {"transform", "translate", "rotate", "scale",
                                                "mirror"};
  const std::vector<field::NodePtr> children = node.children();
  return placing.count(node.name()) && children.size() == 1 ? shape_name(*children[0])
                                                            : node.name();
}

std::string hint_for_shape(const Value& given) {
  if (ValueTraits<shot::NetworkPtr>::read(given))
    return "write passages(of: ...) for the air of a network";
  if (given.get<Number>() || given.get<std::string>())
    return "if it belongs to a clause, write brackets, e.g. name (\"hall \" + n)";
  return "";
}

/// A name that occurs more than once, or null.
const scene::Entry* repeated(const std::vector<scene::Entry>& entries) {
  std::set<std::string> keys;
  for (const scene::Entry& entry : entries)
    if (!keys.insert(entry.key).second) return &entry;
  return nullptr;
}

std::vector<sgm::Piece> Binder::pieces(const scene::Item& item, int count,
                                       const scene::Scope& scope, RandomKey key) {
  std::vector<sgm::Piece> out;
  for (int i = 0; i < count; ++i) {
    const Value shape = values_.value(*item.shape, key.at(static_cast<uint64_t>(i)), scope);
    const auto fields = ValueTraits<std::vector<field::Field>>::read(shape);
    if (!fields || fields->empty())
      values_.fail(item.shape->where,
                   fmt::format("a solid is needed here, not {}", shape.type_name()),
                   hint_for_shape(shape));
    for (const field::Field& f : *fields) out.push_back({shape_name(*f.node()), f});
  }
  return out;
}

grammar::Content Binder::step(const scene::Item& item, const scene::Rule& rule,
                              const grammar::RewriteSite& site) {
  const scene::FrameScope frame(
      resolver_.frames(), fmt::format("rule '{}'", grammar::to_string(site.symbol)), item.where);
  const RuleScope local = scope_of(rule, site);
  const scene::Scope& scope = local;
  ItemClauses clauses;
  sgm::ProductionStep& step = clauses.step;
  const auto* placed = std::any_cast<Transform>(&site.symbol.content.payload);
  if (placed) step.frame = *placed;
  for (const scene::Entry& option : source_.options)
    if (is_clause(option.key)) read_clause(option, site.key, scope, values_, clauses);
  if (const scene::Entry* again = repeated(item.clauses))
    values_.fail(again->where, fmt::format("the item has two clauses '{}'", again->key),
                 "remove one of them");
  const bool connects =
      std::any_of(item.clauses.begin(), item.clauses.end(),
                  [](const scene::Entry& clause) { return clause.key == kConnectClause; });
  for (const scene::Entry& clause : item.clauses) {
    const bool applies = applies_without_glue(clause.key);
    if (connects && !applies)
      values_.fail(
          clause.where,
          fmt::format("'{}' has no effect on a shape that connects two places", clause.key),
          fmt::format("remove it, or remove '{}'", kConnectClause));
    if (placed && !applies)
      values_.fail(
          clause.where,
          fmt::format("'{}' has no effect on a shape that is placed on a network", clause.key),
          "remove it, or move the shape with .translate(...)");
    read_clause(clause, site.key, scope, values_, clauses);
  }
  step.where = item.where;
  for (const sgm::Operation operation : {sgm::Operation::unite, sgm::Operation::subtract,
                                         sgm::Operation::intersect, sgm::Operation::morph})
    if (sgm::sign_of(operation) == item.op) step.operation = operation;
  step.pieces = pieces(item, clauses.pieces, scope, site.key.at("shape"));
  if (item.amount) {
    step.amount = values_.number(*item.amount, site.key.at("amount"), scope);
    if (!(step.amount >= 0 && step.amount <= 1))
      values_.fail(
          item.amount->where,
          fmt::format("a morph's amount must lie between 0% and 100%, not {}%", 100 * step.amount));
  }
  std::string names;
  for (const sgm::Piece& piece : step.pieces) names += (names.empty() ? "" : " ") + piece.name;
  grammar::Content content;
  content.text = fmt::format(
      "{} {}{}", item.op, item.op == "~" ? fmt::format("{:.0f}% ", 100 * step.amount) : "", names);
  if (!step.name.empty()) content.text += fmt::format(" name \"{}\"", step.name);
  if (step.connect)
    content.text +=
        fmt::format(" connect [\"{}\", \"{}\"]", step.connect->first, step.connect->second);
  content.payload = std::move(step);
  return content;
}

grammar::SuccessorItem Binder::part(const scene::Item& item, const scene::Rule& rule) {
  grammar::SuccessorItem part;
  part.where = item.where;
  part.terminal = !item.op.empty();
  part.symbol = part.terminal ? item.op : item.symbol();
  if (item.count)
    part.count = [this, &item, &rule](const grammar::RewriteSite& site) {
      return values_.growing(site, [&]() -> int64_t {
        const RuleScope local = scope_of(rule, site);
        const scene::Scope& scope = local;
        const std::optional<int> count = evaluator_.count(*item.count, site.key, &scope);
        if (!count) throw AlreadyReported{};
        return *count;
      });
    };
  part.content = [this, &item, &rule](const grammar::RewriteSite& site) {
    return values_.growing(site, [&]() -> grammar::Content {
      if (!item.op.empty()) return step(item, rule, site);
      const RuleScope local = scope_of(rule, site);
      const scene::Scope& scope = local;
      grammar::Content content;
      content.payload = site.symbol.content.payload;  // its place on the network
      for (Argument& argument : evaluator_.arguments(*item.shape, site.key, &scope)) {
        if (argument.value.empty()) throw AlreadyReported{};
        content.params.push_back(std::move(argument.value));
      }
      return content;
    });
  };
  return part;
}

void Binder::read_network() {
  for (const scene::Entry& option : source_.options) {
    if (option.key != scene::kDressOption) continue;
    const Value given = values_.value(*option.values.at(0), key_.at(scene::kDressOption), {});
    const auto network = ValueTraits<shot::NetworkPtr>::read(given);
    const auto* unknown = given.get<Value::Name>();
    if (!network)
      values_.fail(
          option.extent,
          fmt::format("'{}' expects a network, not {}", scene::kDressOption, given.type_name()),
          unknown ? did_you_mean(unknown->text, resolver_.known_names(),
                                 fmt::format("declare it with 'network {} = ...'", unknown->text))
                  : "");
    network_ = *network;
  }
  refuse_elements(source_.axiom);
  bool used = false;
  for (const scene::Rule& rule : source_.rules) {
    refuse_elements(rule.items);
    const NetworkSymbol* symbol = element_symbol(rule.head);
    if (!symbol) continue;
    used = true;
    std::vector<std::string> names;
    for (const ElementAttribute& attribute : symbol->attributes) names.emplace_back(attribute.name);
    std::vector<size_t>& order = orders_[&rule];
    for (const scene::Formal& formal : rule.formals) {
      const auto found = std::find(names.begin(), names.end(), formal.name);
      if (found == names.end())
        values_.fail(formal.where,
                     fmt::format("'{}' has no attribute '{}'", symbol->name, formal.name),
                     suggestion(formal.name, names));
      order.push_back(static_cast<size_t>(found - names.begin()));
    }
  }
  if (network_ && !used)
    values_.fail(
        source_.where,
        fmt::format("grammar '{}' has no rule for an element of its network", source_.name),
        "write a rule for " + network_symbol_names("or"));
}

void Binder::refuse_elements(const std::vector<scene::Item>& items) const {
  for (const scene::Item& item : items)
    if (item.op.empty() && element_symbol(item.symbol()))
      values_.fail(item.where,
                   fmt::format("'{}' stands for an element of the network, which a grammar cannot "
                               "add",
                               item.symbol()),
                   "give the symbol another name");
}

grammar::SuccessorItem Binder::elements_part(const NetworkSymbol& symbol) const {
  grammar::SuccessorItem part;
  part.symbol = symbol.name;
  part.where = source_.where;
  const auto elements = std::make_shared<const std::vector<network::Element>>(
      network::elements(*network_, symbol.kind));
  part.count = [elements](const grammar::RewriteSite&) {
    return static_cast<int64_t>(elements->size());
  };
  part.content = [elements, &symbol, plan = network_](const grammar::RewriteSite& site) {
    const network::Element& element = elements->at(static_cast<size_t>(site.repetition));
    return grammar::Content{attributes_of(symbol, *plan, element), element.frame,
                            label_of(symbol, *plan, element)};
  };
  return part;
}

grammar::Grammar Binder::bind() {
  static const scene::Rule none;
  grammar::Grammar out;
  out.name = source_.name;
  out.where = source_.where;
  read_network();
  for (const scene::Item& item : source_.axiom) out.axiom.push_back(part(item, none));
  for (const NetworkSymbol& symbol : network_symbols())
    if (element_symbol(symbol.name) && has_rule(source_, symbol.name))
      out.axiom.push_back(elements_part(symbol));
  for (const scene::Rule& rule : source_.rules) {
    grammar::Production production;
    production.symbol = rule.head;
    production.arity = orders_.count(&rule) ? -1 : static_cast<int>(rule.formals.size());
    production.where = rule.extent;
    if (rule.guard)
      production.guard = [this, &rule](const grammar::RewriteSite& site) {
        return values_.growing(site, [&] {
          const Value holds = values_.value(*rule.guard, site.key, scope_of(rule, site));
          if (const bool* truth = holds.get<bool>()) return *truth;
          values_.fail(rule.guard->where,
                       fmt::format("a guard must be true or false, not {}", holds.type_name()));
        });
      };
    if (rule.weight)
      production.weight = [this, &rule](const grammar::RewriteSite& site) {
        return values_.growing(site, [&] {
          const double weight = values_.number(*rule.weight, site.key, scope_of(rule, site));
          if (!(weight >= 0) || !std::isfinite(weight))
            values_.fail(rule.weight->where,
                         fmt::format("a weight must be a number of at least 0, not {}", weight));
          return weight;
        });
      };
    for (const scene::Item& item : rule.items) production.successor.push_back(part(item, rule));
    out.productions.push_back(std::move(production));
  }
  return out;
}

int64_t Binder::limit(const std::string& option, int64_t fallback) {
  for (const scene::Entry& entry : source_.options) {
    if (entry.key != option) continue;
    const double n = values_.number(*entry.values.at(0), key_.at(option), {});
    if (!(n >= 1 && n <= 1e9))
      values_.fail(entry.extent, fmt::format("'{}' must be a whole number of at least 1", option));
    return static_cast<int64_t>(n);
  }
  return fallback;
}

sgm::Options Binder::options() {
  if (const scene::Entry* again = repeated(source_.options))
    values_.fail(again->where, fmt::format("the grammar has two options '{}'", again->key),
                 "remove one of them");
  const std::vector<std::string> known = option_names();
  for (const scene::Entry& option : source_.options)
    if (std::find(known.begin(), known.end(), option.key) == known.end())
      values_.fail(option.where, fmt::format("a grammar has no option '{}'", option.key),
                   suggestion(option.key, known));
    else if (option.key == kConnectClause)
      values_.fail(option.where,
                   fmt::format("'{}' is not an option of a grammar, because all its shapes would "
                               "connect the same places",
                               kConnectClause),
                   "write it after a shape");
  sgm::Options out;
  for (const scene::Entry& option : source_.options) {
    if (option.key != "geology") continue;
    const Value given = values_.value(*option.values.at(0), key_.at(option.key), {});
    const auto rock = ValueTraits<field::Field>::read(given);
    if (!rock)
      values_.fail(
          option.extent,
          fmt::format("'geology' expects a solid with materials, not {}", given.type_name()),
          "e.g. geology host_rock(rock, of: \"limestone\")");
    if (field::materials_of(*rock).empty())
      values_.fail(option.extent, "the solid of 'geology' has no materials",
                   "assign them with made_of(...) or host_rock(...)");
    out.geology.rock = *rock;
  }
  return out;
}

}  // namespace

Value bind_grammar(const scene::Grammar& source, ReadContext& context) {
  if (source.kind == "lsystem") return bind_lsystem(source, context);
  if (source.kind == "facade") return bind_facade(source, context);
  Binder binder(source, context);
  try {
    if (source.broken) {
      binder.options();
      return Value();
    }
    const grammar::Grammar bound = binder.bind();
    Diagnostics own;
    grammar::check(bound, own);
    context.diagnostics.append(own);
    if (own.has_errors()) return Value();
    const sgm::Options options = binder.options();
    const grammar::Limits limits{binder.limit("steps", kMaxProductions),
                                 binder.limit("limit", kMaxSymbols)};
    sgm::DerivationResult result = sgm::derive(bound, binder.key(), options, limits);
    for (const Diagnostic& d : result.diagnostics.all())
      context.diagnostics.warning(d.where.known() ? d.where : source.where, d.message, d.hint);
    if (result.field.bounds().isEmpty())
      context.diagnostics.warning(
          source.where, fmt::format("the grammar '{}' produces nothing", source.name),
          result.counts.total() == 0 ? "no production of a shape was applied; see 'vug tree'" : "");
    context.shot.derivations.push_back(
        {source.name, std::move(result.tree), result.counts.total()});
    if (!result.places.empty())
      result.field = sgm::with_places(result.field, std::move(result.places));
    Value made = Object{"field", result.field};
    context.resolver.record(made, source.extent);
    return made;
  } catch (const AlreadyReported&) {
    return Value();
  } catch (const Error& error) {
    std::string message = error.what();
    for (const std::string& doing : error.context()) message += ", while " + doing;
    context.diagnostics.error(error.where().known() ? error.where() : source.where, message,
                              error.hint());
    return Value();
  }
}

}  // namespace vug::loading
