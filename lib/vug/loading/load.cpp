// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/loading/attribute_check.h>
#include <vug/loading/declaration_cache.h>
#include <vug/loading/grammar_binding.h>
#include <vug/loading/load.h>
#include <vug/loading/reader.h>
#include <vug/loading/scouted_cameras.h>
#include <vug/loading/validate.h>
#include <vug/loading/variant_overrides.h>
#include <vug/scene/check.h>
#include <vug/scene/parser.h>
#include <vug/scene/report.h>
#include <vug/volume/level_set_field.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace vug::loading {
namespace {

std::vector<std::string> declaration_words() {
  std::vector<std::string> words = {"param", "let", "def", "seed", "include", "grammar"};
  for (const DeclarationKind* kind : declaration_kinds()) words.push_back(kind->info.name);
  return words;
}

/// Reports an `on` for kinds that do not take one.
void check_target(const scene::Declaration& declaration, const DeclarationKind& kind,
                  Diagnostics& diagnostics) {
  if (!declaration.target) return;
  if (!kind.target_type.empty()) {
    if (!declaration.more_targets.empty() && !kind.several_targets)
      diagnostics.error(
          declaration.more_targets[0]->where,
          fmt::format("'{}' takes a single {} after 'on'", declaration.kind, kind.target_type),
          "several are allowed for: cells");
    return;
  }
  std::vector<std::string> standing;
  for (const DeclarationKind* each : declaration_kinds())
    if (!each->target_type.empty())
      standing.push_back(fmt::format("{} (on a {})", each->info.name, each->target_type));
  diagnostics.error(
      declaration.on_where, fmt::format("'{}' does not take 'on'", declaration.kind),
      fmt::format("remove 'on'; declarations with 'on': {}", fmt::join(standing, ", ")));
}

/// The scene text with its overrides and those of the variant as comments, from which the scene can
/// be rebuilt.
std::string recipe(const scene::Document& document, const LoadOptions& options, uint64_t seed,
                   bool moves) {
  std::string text =
      joined_text(document.sources.empty() ? "" : document.sources[0]->text, options.appended);
  for (const auto& changes :
       {options.overrides, variant_overrides(document, options.variant, options.overrides)})
    for (const scene::Override& change : changes)
      text += fmt::format("# -D {}={}\n", change.name, change.text);
  if (options.seed) text += fmt::format("# --seed {}\n", seed);
  if (moves) text += fmt::format("# --frame {}\n", options.frame);
  if (options.draft) text += "# --quality draft\n";
  return text;
}

Value read_declaration(const scene::Declaration& declaration, const DeclarationKind& kind,
                       ReadContext& context) {
  Value value = kind.read(declaration, context);
  return declaration.incomplete ? Value() : value;
}

/// The values of `KIND NAME[i in LIST] ...`, one for each element. Their names are NAME[0], ...
Value read_loop(const scene::Declaration& declaration, const DeclarationKind& kind,
                ReadContext& context, DeclarationCache& cached) {
  scene::Evaluator::DeclarationScope scope(context.evaluator);
  const DeclarationCache::Recording recording(cached, declaration);
  const uint64_t uses = context.resolver.frame_uses();
  const scene::Expr& loop = *declaration.loop;
  const Value elements = context.evaluator.eval(loop, context.evaluator.key(declaration).at("for"));
  if (elements.empty()) return Value();
  const bool animated = context.resolver.frame_uses() > uses;
  const std::vector<scene::DeclarationName> used = recording.uses();
  const List& list = *elements.get<List>();
  List values;
  for (const Value& element : list) {
    const List& given = *element.get<List>();
    scene::Scope variables;
    for (const scene::Operand& name : loop.operands.back().value->operands)
      variables.names.emplace_back(name.value->text, given[variables.names.size()]);
    scene::Declaration made = declaration;
    made.name = fmt::format("{}[{}]", declaration.name, values.size());
    values.push_back(cached(made.kind, made.name, [&] {
      if (animated) context.resolver.use_frame();
      context.resolver.record_use(used);
      scope.begin_element(variables, list.size());
      return read_declaration(made, kind, context);
    }));
  }
  const bool faulty =
      std::any_of(values.begin(), values.end(), [](const Value& each) { return each.empty(); });
  if (!faulty) recording.keep_loop();
  return faulty ? Value() : Value(std::move(values));
}

/// Reports a loop of a declaration that is not a value.
void reject_loop(const scene::Declaration& declaration, Diagnostics& diagnostics) {
  std::vector<std::string> allowed;
  for (const DeclarationKind* each : declaration_kinds())
    if (each->is_value) allowed.push_back(each->info.name);
  diagnostics.error(
      declaration.loop->where,
      fmt::format("'{}' cannot be declared for each element of a list", declaration.kind),
      fmt::format("possible for: {}", fmt::join(allowed, ", ")));
}

void register_declarations(const scene::Document& document, ReadContext& context,
                           DeclarationCache& cached) {
  for (const scene::Declaration& declaration : document.declarations) {
    const DeclarationKind* kind = find_declaration_kind(declaration.kind);
    if (!kind || declaration.broken)
      context.resolver.declare(declaration.kind, declaration.name, [] { return Value(); });
    if (declaration.broken) continue;  // already reported
    if (!kind) {
      context.diagnostics.error(declaration.kind_where,
                                fmt::format("unknown declaration '{}'", declaration.kind),
                                suggestion(declaration.kind, declaration_words()));
      continue;
    }
    check_target(declaration, *kind, context.diagnostics);
    if (!kind->is_value) {
      if (declaration.loop) reject_loop(declaration, context.diagnostics);
      kind->read(declaration, context);
      continue;
    }
    context.resolver.declare(declaration.kind, declaration.name,
                             [&declaration, kind, &context, &cached] {
                               if (declaration.loop)
                                 return read_loop(declaration, *kind, context, cached);
                               return cached(declaration.kind, declaration.name, [&] {
                                 const scene::Evaluator::DeclarationScope scope(context.evaluator);
                                 return read_declaration(declaration, *kind, context);
                               });
                             });
  }
  for (const scene::Grammar& grammar : document.grammars)
    context.resolver.declare("grammar", grammar.name, [&grammar, &context, &cached] {
      // A declaration with a loop may be the first to use the grammar, which must not see its
      // names.
      const scene::Evaluator::DeclarationScope scope(context.evaluator);
      return cached("grammar", grammar.name, [&] { return bind_grammar(grammar, context); });
    });
}

/// The functions of the document except those that are private to a module.
std::vector<KindInfo> callable_functions(const scene::Document& document) {
  std::vector<KindInfo> all;
  for (const scene::Def& def : document.defs)
    if (def.name.find("._") == std::string::npos) all.push_back(scene::info_of(def));
  return all;
}

/// The value of an expression that is not part of the text.
Value evaluate_expression(const std::string& text, scene::Evaluator& evaluator, Loaded& loaded) {
  const std::string file = "expression";
  loaded.sources.push_back(std::make_shared<const scene::Source>(scene::Source{file, text}));
  const scene::ExprPtr expr = scene::parse_expression(text, file, loaded.diagnostics);
  if (!expr) return {};
  Value value = evaluator.eval(*expr, evaluator.root().at(file));
  const auto* name = value.get<Value::Name>();
  if (!name || expr->kind != scene::ExprKind::name || name->text != expr->text) return value;
  Diagnostics found;
  found.error(expr->where, fmt::format("unknown name '{}'", name->text));
  evaluator.report(found, {{"", value, expr->where}});
  return {};
}

Loaded evaluate(const scene::Document& document, Loaded loaded, const std::filesystem::path& file,
                const LoadOptions& options) {
  volume::install_grid_loader();
  Resolver resolver(document);
  scene::Evaluator evaluator(document, resolver, loaded.diagnostics,
                             {options.overrides, options.seed, options.frame, options.variant});
  loaded.sources = evaluator.sources();  // include the overrides, which reports quote
  loaded.shot.name = file.stem().string();
  loaded.shot.seed = evaluator.seed();
  loaded.shot.frame = options.frame;
  loaded.shot.draft = options.draft;
  Hasher texts;
  if (options.draft) texts.add("draft");
  for (const auto& source : document.sources)
    texts.add_value(source->text.size()).add(source->text);
  loaded.shot.text_digest = texts.finish();
  ReadContext context{document,    evaluator, resolver, loaded.diagnostics,
                      loaded.shot, options,   file};
  DeclarationCache cached(context);
  register_declarations(document, context, cached);
  evaluator.check_all();
  for (const scene::ParamValue& each : evaluator.params())
    loaded.parameters.push_back({each.param->name, each.value, each.fallback, each.low, each.high,
                                 each.param->doc, each.param->where});
  for (const scene::Declaration& declaration : document.declarations)
    resolver.declared(declaration.kind, declaration.name, declaration.where, loaded.diagnostics);
  for (const scene::Grammar& grammar : document.grammars)
    resolver.declared("grammar", grammar.name, grammar.where, loaded.diagnostics);
  evaluator.check_uncalled();
  // A fault may be the reason why a name is not used, and texts for inclusion declare names for
  // others.
  if (!loaded.diagnostics.has_errors() && !is_empty_scene(loaded.shot))
    scene::check_unused_names(document, loaded.diagnostics);
  validate(loaded.shot, document, loaded.diagnostics);
  if (!loaded.diagnostics.has_errors()) check_attributes(document, loaded.shot, loaded.diagnostics);
  loaded.shot.animated = resolver.frame_uses() > 0;
  if (!loaded.diagnostics.has_errors()) cached.forget_others();
  for (scene::VariantValues& each : evaluator.variants())
    loaded.variants.push_back({each.variant->name, std::move(each.values), each.variant->where});
  loaded.functions = callable_functions(document);
  if (!options.expression.empty())
    loaded.value = evaluate_expression(options.expression, evaluator, loaded);
  loaded.provenance = std::move(resolver.provenance());
  loaded.shot.recipe = recipe(document, options, evaluator.seed(), loaded.shot.animated);
  return loaded;
}

/// The document of a text, with the shots of its scouted cameras.
scene::Document parse_scene(const std::string& text, const std::string& file,
                            const LoadOptions& options, Diagnostics& diagnostics) {
  scene::ParseOptions parse_options;
  parse_options.include_folders = options.include_folders;
  parse_options.appended = options.appended;
  parse_options.read = options.read;
  scene::Document document = scene::parse(text, file, diagnostics, parse_options);
  if (options.unscouted) {
    forget_scouted_cameras(document);
    return document;
  }
  const std::vector<std::string> shots = scouted_includes(document, file, diagnostics);
  if (diagnostics.has_errors()) forget_scouted_cameras(document);  // they have been reported
  if (shots.empty() || diagnostics.has_errors()) return document;
  parse_options.appended.insert(parse_options.appended.end(), shots.begin(), shots.end());
  diagnostics = {};
  document = scene::parse(text, file, diagnostics, parse_options);
  use_scouted_cameras(document);
  return document;
}

}  // namespace

std::string Loaded::report(const Diagnostics& others) const {
  return scene::report(others, sources);
}

std::string joined_text(std::string text, const std::vector<std::string>& appended) {
  for (const std::string& each : appended) {
    if (!text.empty() && text.back() != '\n') text += '\n';
    text += each;
  }
  if (!appended.empty() && !text.empty() && text.back() != '\n') text += '\n';
  return text;
}

Loaded load_text(std::string text, const std::string& file, const LoadOptions& options) {
  Loaded loaded;
  const scene::Document document = parse_scene(text, file, options, loaded.diagnostics);
  return evaluate(document, std::move(loaded), file, options);
}

Loaded load(const std::filesystem::path& file, const LoadOptions& options) {
  return load_text(read_text(file), file.string(), options);
}

}  // namespace vug::loading
