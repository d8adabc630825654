// SPDX-License-Identifier: Apache-2.0
#include <vug/building/instance_source.h>
#include <vug/loading/reader.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::loading {
namespace {

namespace fs = std::filesystem;

Schema<shot::PointInstancer> place_schema() {
  Schema<shot::PointInstancer> s("place", "declaration");
  s.doc(
       "Instances of objects or scenes: place NAME { of OBJECT at PLACES }. A placed "
       "object is not shown on its own.")
      .param("of", &shot::PointInstancer::of,
             {.doc = "the model: an object, a scene(\"file.vug\"), or several to choose from",
              .required = true})
      .param("at", &shot::PointInstancer::at,
             {.doc = "sources of positions: points such as (1, 0, 2), pose(...), scatter(...), "
                     "grove(...), points(...)",
              .dimension = Dimension::length,
              .required = true})
      .param("shares", &shot::PointInstancer::shares,
             {.doc = "relative frequency of each model", .min = 0})
      .param(
          "material", &shot::PointInstancer::material,
          {.doc = "material of all instances instead of their own; its masks are evaluated at the "
                  "instance, those of a model's own material on the model"})
      .param("floating", &shot::PointInstancer::floating,
             {.doc = "instances hang in mid-air on purpose: no check reports them"})
      .param("apart", &shot::PointInstancer::apart,
             {.doc = "name each instance separately in mattes: NAME/1, NAME/2 ..."});
  return s;
}

scene::Override override_of(const std::string& text) {
  const size_t at = text.find('=');
  if (at == text.npos)
    throw Error(ErrorCode::bad_input, fmt::format("'{}' is not of the form NAME=VALUE", text));
  return {text.substr(0, at), text.substr(at + 1)};
}

/// The file relative to the scene text, else in the include folders, as for `include`; the first of
/// these paths if there is none.
fs::path find_scene_file(const fs::path& file, const SourceLocation& where,
                         const LoadOptions& options) {
  std::error_code failed;
  if (fs::exists(file, failed)) return file;
  const fs::path named = file.lexically_relative(fs::path(where.file).parent_path());
  for (const fs::path& folder : options.include_folders)
    if (!named.empty() && fs::is_regular_file(folder / named, failed)) return folder / named;
  return file;
}

/// The shot of the other scene; null, with a diagnostic, if it cannot be loaded.
std::shared_ptr<const shot::Shot> load_model(const shot::Model& model, const SourceLocation& where,
                                             ReadContext& context) {
  LoadOptions options;
  options.include_folders = context.options.include_folders;
  options.enclosing_scenes = context.options.enclosing_scenes;
  options.frame = context.options.frame;
  options.draft = context.options.draft;
  options.max_memory = context.options.max_memory;
  options.enclosing_scenes.push_back(fs::weakly_canonical(context.file));
  const fs::path own = fs::weakly_canonical(model.file);
  const auto refuse = [&](const std::string& what, const std::string& hint) {
    context.diagnostics.error(where, what, hint);
    return nullptr;
  };
  if (std::find(options.enclosing_scenes.begin(), options.enclosing_scenes.end(), own) !=
      options.enclosing_scenes.end())
    return refuse(fmt::format("the scene '{}' would contain itself", model.name), "");
  try {
    for (const std::string& text : model.with) options.overrides.push_back(override_of(text));
    if (model.seed) options.seed = static_cast<uint64_t>(*model.seed);
    Loaded loaded = load(model.file, options);
    for (const Diagnostic& fault : loaded.diagnostics.all())
      if (fault.severity == Severity::error)
        return refuse(fmt::format("the scene '{}' has faults and cannot be placed", model.name),
                      fmt::format("{}: {}", to_string(fault.where), fault.message));
    if (loaded.shot.animated) context.resolver.use_frame();
    Hasher texts;
    texts.add_value(context.shot.text_digest)
        .add_value(loaded.shot.text_digest)
        .add_value(options.seed.value_or(~0ull));
    for (const std::string& text : model.with) texts.add_value(text.size()).add(text);
    context.shot.text_digest = texts.finish();
    return std::make_shared<const shot::Shot>(std::move(loaded.shot));
  } catch (const Error& error) {
    if (error.code() != ErrorCode::bad_input) throw;
    return refuse(error.what(), error.hint());
  }
}

/// Resolves the model: its object, mesh or scene; false with a diagnostic.
bool resolve_model(shot::Model& model, const SourceLocation& where, ReadContext& context) {
  context.resolver.use_whole_text();
  if (!model.file.empty()) {
    model.file = find_scene_file(model.file, where, context.options);
    model.scene = load_model(model, where, context);
    return model.scene != nullptr;
  }
  std::vector<std::string> names;
  for (const shot::ObjectPlan& object : context.shot.objects) names.push_back(object.name);
  if (std::find(names.begin(), names.end(), model.name) != names.end())
    model.mesh = nullptr;  // the object of that name, rather than its mesh
  else if (!model.mesh) {
    context.diagnostics.error(where, fmt::format("there is no object '{}' to place", model.name),
                              suggestion(model.name, names));
    return false;
  }
  return true;
}

/// The location of an entry of the block, else that of the declaration's name.
SourceLocation location_of_entry(const char* key, const scene::Declaration& declaration) {
  const scene::Entry* entry = declaration.find_entry(key);
  return entry ? entry->where : declaration.where;
}

/// An error about shares and model numbers that do not match the models; else nothing.
std::optional<Error> find_mismatch(const shot::PointInstancer& plan,
                                   const scene::Declaration& declaration) {
  const auto refuse = [&](const char* key, const std::string& what, const std::string& hint = {}) {
    return Error(ErrorCode::bad_input, what, location_of_entry(key, declaration), hint);
  };
  if (plan.of.empty()) return refuse("of", "there is nothing to place: the list is empty");
  if (!plan.shares.empty() && plan.shares.size() != plan.of.size())
    return refuse("shares", fmt::format("{} shares do not match {} models", plan.shares.size(),
                                        plan.of.size()));
  if (!plan.shares.empty() &&
      std::all_of(plan.shares.begin(), plan.shares.end(), [](double s) { return s == 0; }))
    return refuse("shares", "the shares are all 0: nothing could be chosen");
  const auto count = static_cast<int>(plan.of.size());
  for (const shot::InstanceSource& at : plan.at) {
    const auto* numbered = at->target<building::IndexedInstanceSource>();
    if (numbered && numbered->last_model >= count)
      return refuse(
          "at",
          fmt::format("an instance uses model number {}, but the last model of '{}' is number {}",
                      numbered->last_model, declaration.name, count - 1),
          "models are counted from 0, in the order of 'of'; a grove has one of 'diameters' per "
          "model");
  }
  return std::nullopt;
}

}  // namespace

const DeclarationKind& place_declaration() {
  static const DeclarationKind kind = {
      place_schema().info(),
      [](const scene::Declaration& declaration, ReadContext& context) -> Value {
        std::optional<shot::PointInstancer> plan = read_block(place_schema(), declaration, context);
        if (!plan) return Value();
        plan->name = declaration.name;
        plan->where = declaration.where;
        plan->key = context.evaluator.key(declaration);
        if (const std::optional<Error> fault = find_mismatch(*plan, declaration)) {
          context.diagnostics.error(fault->where(), fault->what(), fault->hint());
          return Value();
        }
        for (shot::Model& model : plan->of)
          if (!resolve_model(model, declaration.where, context)) return Value();
        context.shot.instancers.push_back(std::move(*plan));
        return Value(Value::Name{declaration.name});
      }};
  return kind;
}

}  // namespace vug::loading
