// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/evaluator.h>
#include <vug/scene/parser.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vug::scene {

namespace {

constexpr double kMaxSeed = 0x1p53;

}  // namespace

Evaluator::Evaluator(const Document& document, Resolver& resolver, Diagnostics& diagnostics,
                     EvaluatorOptions options)
    : document_(document),
      resolver_(resolver),
      diagnostics_(&diagnostics),
      options_(std::move(options)) {
  params_.resize(document.params.size());
  for (size_t i = 0; i < params_.size(); ++i) {
    params_[i].param = &document.params[i];
    globals_[document.params[i].name].param = &params_[i];
  }
  for (const Let& let : document.lets) globals_[let.name].let = &let;
  for (const Def& def : document.defs) defs_[def.name] = {&def, info_of(def)};
  read_overrides();
  read_variant();
  read_seed();
}

void Evaluator::read_overrides() {
  for (const Override& given : options_.overrides) {
    const std::string file = "-D " + given.name;
    if (!document_.find_param(given.name)) {
      if (document_.skipped.may_declare(given.name)) continue;
      std::vector<std::string> names;
      for (const Param& param : document_.params) names.push_back(param.name);
      const std::string near = did_you_mean(given.name, names);
      diagnostics_->error({file, 0, 0}, fmt::format("the scene has no param '{}'", given.name),
                          names.empty()
                              ? "it declares no parameters; add one with e.g. 'param R = 1m'"
                              : fmt::format("{}{}its params: {}", near, near.empty() ? "" : " ",
                                            fmt::join(names, ", ")));
      continue;
    }
    sources_.push_back(std::make_shared<const Source>(Source{file, given.text}));
    if (ExprPtr expr = parse_expression(given.text, file, *diagnostics_))
      overrides_[given.name] = std::move(expr);
  }
}

void Evaluator::read_seed() {
  if (options_.seed) {
    seed_ = *options_.seed;
    return;
  }
  if (!document_.seed) return;
  const Value value = eval(*document_.seed, RandomKey(0).at("seed"));
  // Values used by the seed were drawn without it: discard and draw them again.
  for (auto& [name, global] : globals_) global.value.reset();
  if (value.empty()) return;
  const Number* n = value.get<Number>();
  if (n && n->dimension == Dimension::none && n->value == std::floor(n->value) && n->value >= 0 &&
      n->value <= kMaxSeed)
    seed_ = static_cast<uint64_t>(n->value);
  else
    diagnostics_->error(document_.seed->where,
                        fmt::format("a seed must be a whole number from 0 to 2^53, not {}",
                                    n ? to_string(value) : value.type_name()));
}

/// Starts to count the work of an expression, unless it is part of another one or of an element of
/// a loop.
void Evaluator::begin_expression() {
  if (depth_ == 0 && planned_ <= 1) done_ = 0;
}

Value Evaluator::eval(const Expr& expr, RandomKey key, const Scope* scope) {
  begin_expression();
  return evaluate(expr, {key, scope_or_default(scope), {}});
}

Value Evaluator::eval_as(std::string_view type, const Expr& expr, RandomKey key) {
  begin_expression();
  return evaluate(expr, {key, variables_, type});
}

std::vector<Value> Evaluator::eval(const Entry& entry, RandomKey key, const Scope* scope) {
  std::vector<Value> values;
  for (const ExprPtr& expr : entry.values)
    values.push_back(eval(*expr, key.at(entry.key).at(values.size()), scope));
  return values;
}

std::optional<int> Evaluator::count(const Expr& expr, RandomKey key, const Scope* scope) {
  const Context context{key, scope_or_default(scope), {}};
  const auto whole = [&](const Expr& from) -> std::optional<int> {
    const Value value = evaluate(from, context);
    if (value.empty() || !is_known(value, from)) return std::nullopt;
    const Number* n = value.get<Number>();
    if (n && (n->dimension == Dimension::none || n->dimension == Dimension::ratio) &&
        n->value == std::floor(n->value) && n->value >= 0 && n->value <= 1e9)
      return static_cast<int>(n->value);
    site(from).fault(fmt::format("a count must be a whole number, not {}",
                                 n ? to_string(value) : value.type_name()),
                     n ? "see floor, ceil and round" : "");
    return std::nullopt;
  };
  if (expr.kind != ExprKind::range) return whole(expr);
  const auto low = whole(*expr.operands[0].value), high = whole(*expr.operands[1].value);
  if (!low || !high) return std::nullopt;
  if (*low > *high) {
    site(expr).fault(
        fmt::format("invalid range {}..{}: the first end exceeds the second", *low, *high));
    return std::nullopt;
  }
  RandomStream stream(key.at(expr.path));
  return *low + static_cast<int>(stream.below(static_cast<uint32_t>(*high - *low) + 1));
}

/// Whether a name that is being evaluated is used again, which is an error.
bool Evaluator::is_cyclic(const std::vector<std::string>& pending, const std::string& name,
                          const SourceLocation& where) {
  const auto first = std::find(pending.begin(), pending.end(), name);
  if (first == pending.end()) return false;
  FaultSite{where, *diagnostics_}.fault(
      fmt::format("'{}' depends on itself", name),
      fmt::format("{} -> {}", fmt::join(first, pending.end(), " -> "), name));
  return true;
}

Value Evaluator::global(const std::string& name, Global& global, const SourceLocation& where) {
  if (global.value) {
    if (global.animated) resolver_.use_frame();
    resolver_.record_use(global.uses);
    return use(*global.value, global.height, where);
  }
  if (is_cyclic(pending_, name, where)) return {};
  if (pending_.size() >= Resolver::kMaxPending)
    return FaultSite{where, *diagnostics_}.fault(
        fmt::format("more than {} names depend on each other in a chain", Resolver::kMaxPending));
  pending_.push_back(name);
  const FrameScope frame(resolver_.frames(),
                         fmt::format("{} '{}'", global.param ? "param" : "let", name), where);
  const uint64_t uses = resolver_.frame_uses();
  const Resolver::UseScope used(resolver_);
  const int deepest = std::exchange(deepest_, depth_);
  const double planned = std::exchange(planned_, 1), done = std::exchange(done_, 0);
  Value value = global.param
                    ? param(*global.param, root().at("param").at(name))
                    : evaluate(*global.let->value, {root().at("let").at(name), nullptr, {}});
  pending_.pop_back();
  if (value.get<Object>() || value.get<List>()) global.height = deepest_ - depth_;
  deepest_ = deepest;
  planned_ = planned;
  done_ = done;
  if (document_.skipped.doubtful.count(name)) value = {};
  global.value = value;
  global.animated = resolver_.frame_uses() > uses;
  global.uses = used.uses();
  return use(*global.value, global.height, where);
}

/// Checks the nesting depth that a use of the value adds: each level takes stack space.
Value Evaluator::use(const Value& value, int nesting, const SourceLocation& where) {
  constexpr int kMaxHeight = 10000;
  const int height = depth_ + nesting;
  if (height > kMaxHeight)
    return FaultSite{where, *diagnostics_}.fault(
        fmt::format("more than {} nested operations", kMaxHeight),
        "combine independent solids in one list: union([a, b, c])");
  deepest_ = std::max(deepest_, height);
  return value;
}

Value Evaluator::param(ParamValue& param, RandomKey key) {
  const Context context{key, nullptr, {}};
  const Param& declared = *param.param;
  if (declared.low) {
    param.low = evaluate(*declared.low, context);
    param.high = evaluate(*declared.high, context);
  }
  param.fallback = evaluate(*declared.value, context);
  if (!in_range(param, param.fallback, declared.value->where)) param.fallback = {};
  const auto given = overrides_.find(declared.name);
  const ExprPtr& own = given == overrides_.end() ? declared.given : given->second;
  return param.value = own ? replacement(param, *own, context) : param.fallback;
}

Value Evaluator::replacement(const ParamValue& param, const Expr& expr, const Context& context) {
  Value value = match_type(param.fallback, evaluate(expr, context),
                           fmt::format("param '{}'", param.param->name), expr.where);
  return in_range(param, value, expr.where) ? value : Value();
}

/// An override or argument must have the type of the default; a plain number takes its dimension,
/// so that -D SIZE=2 means metres where the scene says SIZE = 30cm.
Value Evaluator::match_type(const Value& fallback, Value given, const std::string& what,
                            const SourceLocation& where) {
  if (fallback.empty() || given.empty()) return {};
  const FaultSite there{where, *diagnostics_};
  const Number* model = fallback.get<Number>();
  const Number* number = given.get<Number>();
  const bool names = fallback.get<Value::Name>() && given.get<Value::Name>();
  const auto is_bare = [](const Number& n) {
    return n.dimension == Dimension::none || n.dimension == Dimension::ratio;
  };
  if (model && number && (is_bare(*number) || number->dimension == model->dimension)) {
    Number value = *number, wanted = *model;
    if (is_bare(wanted)) return value;
    if (!unify_dimensions(value, wanted, what + " cannot mix", there)) return {};
    return value;
  }
  if (names || (!model && given.type_name() == fallback.type_name())) return given;
  return there.fault(
      fmt::format("{} is {}, not {}", what, fallback.type_name(), given.type_name()));
}

bool Evaluator::in_range(const ParamValue& param, Value& value, const SourceLocation& where) {
  if (!param.param->low || value.empty() || param.low.empty() || param.high.empty()) return true;
  const std::string& name = param.param->name;
  const Number* low = param.low.get<Number>();
  const Number* high = param.high.get<Number>();
  const Number* n = value.get<Number>();
  if (!low || !high || !n) {
    FaultSite{where, *diagnostics_}.fault(
        fmt::format("only numbers can have a range; param '{}' is {}", name, value.type_name()));
    return false;
  }
  Number least = *low, most = *high, given = *n;
  const FaultSite there{where, *diagnostics_};
  if (!unify_dimensions(least, most, "the ends of a range are", there) ||
      !unify_dimensions(given, least, fmt::format("param '{}' cannot mix", name), there) ||
      !unify_dimensions(given, most, fmt::format("param '{}' cannot mix", name), there))
    return false;
  value = given;
  if (least.value > most.value) {
    FaultSite{param.param->low->where, *diagnostics_}.fault(
        fmt::format("the range of param '{}' is reversed", name), "write the smaller end first");
    return false;
  }
  if (given.value >= least.value && given.value <= most.value) return true;
  const auto text = [](const Number& each) { return quantity_text(each.value, each.dimension); };
  const bool near = text(given) == text(least) || text(given) == text(most);
  there.fault(fmt::format("param '{}' is {}, outside {}..{}", name,
                          near ? to_string(value) : text(given), text(least), text(most)));
  return false;
}

const std::vector<ParamValue>& Evaluator::params() {
  for (const Param& declared : document_.params)
    global(declared.name, globals_[declared.name], declared.where);
  return params_;
}

void Evaluator::check_all() {
  params();
  for (const Let& let : document_.lets) global(let.name, globals_[let.name], let.where);
}

std::vector<std::shared_ptr<const Source>> Evaluator::sources() const {
  auto all = document_.sources;
  all.insert(all.end(), sources_.begin(), sources_.end());
  return all;
}

}  // namespace vug::scene
