// SPDX-License-Identifier: Apache-2.0
#include <vug/base/digester.h>
#include <vug/loading/reader.h>
#include <vug/loading/variant_overrides.h>
#include <vug/scene/statement_digests.h>
#include <vug/shot/cell_attributes.h>
#include <vug/shot/cell_stages.h>
#include <vug/shot/rescatter.h>

#include <algorithm>

namespace vug::loading {
namespace {

Schema<shot::CellsPlan> cells_schema() {
  Schema<shot::CellsPlan> s("cells", "declaration");
  ParamSpec spacing = positive_length("distance between neighbouring cells");
  spacing.required = true;
  s.doc(
       "A mesh, or several meshes, with the attributes of a network of cells at their vertices: "
       "cells NAME on MESH { spacing 2cm  run RULE, RULE(...) }.")
      .cite("gobron2006")
      .param("spacing", &shot::CellsPlan::spacing, spacing)
      .param("grid", &shot::CellsPlan::grid, {.doc = "the pattern of the cells; default: random"})
      .param(
          "relax", &shot::CellsPlan::relax,
          {.doc = "relaxation steps, in which cells repel each other; default: those of the grid",
           .min = 0,
           .max = 1000})
      .choice("harmonise", &shot::CellsPlan::harmonise,
              {{"squared", cells::Force::squared}, {"paper", cells::Force::paper}},
              "law of the repulsion: squared is more even, paper is that of the source")
      .param(
          "run", &shot::CellsPlan::run,
          {.doc = "rules, with begin, steps and where, or lists of rules; applied in this order in "
                  "each step",
           .required = true})
      .param("move", &shot::CellsPlan::move,
             {.doc = "displace the mesh with its cells: to their P, and by their height along its "
                     "normal"})
      .param("holes", &shot::CellsPlan::holes,
             {.doc = "cut holes into the mesh where cells have been removed"})
      .param(
          "refine", &shot::CellsPlan::refine,
          {.doc = "subdivide triangles that are larger than cells, so that all cells are visible; "
                  "default: for meshes from files"})
      .param("steps", &shot::CellsPlan::steps,
             {.doc = "steps of the whole run; default: as many as the rules need, 100 for rules "
                     "without an end",
              .min = 0,
              .max = 1000000})
      .param("rescatter", &shot::CellsPlan::rescatter,
             {.doc = "number of times, evenly over the run, that the displaced surface becomes a "
                     "level set with new cells; for surfaces that grow by more than the spacing",
              .min = 0,
              .max = 100})
      .param(
          "from", &shot::CellsPlan::from,
          {.doc = "a .vdb of points that vug build has written for such cells; the run continues "
                  "with their attributes at their step"})
      .param("files", &shot::CellsPlan::files,
             {.doc = "outputs of vug build in addition to the mesh: any of \"points\" (a .vdb), "
                     "\"grids\" (next to the level set) and \"csv\""})
      .param("half", &shot::CellsPlan::half,
             {.doc = "store numbers in points and grids with 16 bits"});
  return s;
}

/// Reports unknown names among the values of `files` and returns false for them.
bool check_files(const scene::ExprPtr& expr, Diagnostics& diagnostics) {
  const std::vector<std::string>& known = shot::cell_files();
  bool fine = true;
  if (expr->kind == scene::ExprKind::text &&
      std::find(known.begin(), known.end(), expr->text) == known.end()) {
    fine = false;
    diagnostics.error(expr->where, "unknown file of cells '" + expr->text + "'",
                      suggestion(expr->text, known));
  }
  for (const scene::Operand& operand : expr->operands)
    fine &= check_files(operand.value, diagnostics);
  return fine;
}

/// The values of an entry that names kinds of a registry.
Value kinds_of(const std::string& type, const scene::Entry& entry, RandomKey key,
               ReadContext& context) {
  List all;
  for (const scene::ExprPtr& expr : entry.values) {
    Value made = kind_value(*find_registry(type), *expr, key.at(entry.key).at(all.size()), context);
    // A list, such as a named recipe, stands for its elements.
    const List* list = made.get<List>();
    if (!list) all.push_back(std::move(made));
    if (list) all.insert(all.end(), list->begin(), list->end());
  }
  if (std::any_of(all.begin(), all.end(), [](const Value& each) { return each.empty(); }))
    return Value();
  return all.size() == 1 ? all[0] : Value(std::move(all));
}

/// `still`: set to whether only `steps` may depend on the frame.
Arguments arguments_of(const scene::Declaration& declaration, ReadContext& context, bool& still) {
  const auto type_of = [](const scene::Entry& entry) -> std::string {
    return entry.key == "run" ? "rule" : entry.key == "grid" ? "grid" : "";
  };
  const uint64_t frame_uses = context.resolver.frame_uses();
  scene::Declaration plain = declaration, clock = declaration;
  plain.entries.clear();
  clock.entries.clear();
  Arguments arguments;
  for (const scene::Entry& entry : declaration.entries) {
    if (type_of(entry).empty())
      (entry.key == "steps" ? clock : plain).entries.push_back(entry);
    else
      arguments.push_back(
          {entry.key, kinds_of(type_of(entry), entry, context.evaluator.key(declaration), context),
           entry.extent});
  }
  const auto is_choice = [](const std::string& key, const std::string& word) {
    return has_choice(cells_schema().info(), key, word);
  };
  for (Argument& each : block_arguments(plain, is_choice, context)) {
    const Number* number = each.value.get<Number>();
    if (each.name == "spacing" && number && !(number->value > 0)) {
      context.diagnostics.error(each.where, "the spacing of cells must be a length above 0",
                                "for instance: spacing 2cm");
      each.value = Value();
    }
    if (each.name == "files")
      for (const scene::ExprPtr& value : declaration.find_entry("files")->values)
        if (!check_files(value, context.diagnostics)) each.value = Value();
    arguments.push_back(std::move(each));
  }
  still = context.resolver.frame_uses() == frame_uses;
  for (Argument& each : block_arguments(clock, is_choice, context))
    arguments.push_back(std::move(each));
  return arguments;
}

/// Identifies the text from which the cells follow; nothing if it may depend on the frame.
std::optional<Digest> inputs_of(const scene::Declaration& declaration, ReadContext& context) {
  const LoadOptions& options = context.options;
  const scene::StatementDigests digests(context.document, options.include_folders);
  const auto text =
      digests.find_with_mentioned(declaration.kind, scene::name_without_index(declaration.name));
  if (!text) return std::nullopt;
  Digester all;
  all(*text, declaration.name, context.evaluator.seed(), options.draft, options.overrides,
      variant_overrides(context.document, options.variant, options.overrides));
  // The files of surveys include others, which the text does not name.
  std::error_code missing;
  for (const shot::NetworkPlan& plan : context.shot.networks)
    for (const std::filesystem::path& file : plan.network->files)
      all(file, std::filesystem::file_size(file, missing),
          std::filesystem::last_write_time(file, missing).time_since_epoch().count());
  return all.finish();
}

/// The supporting meshes, with combined meshes split into their parts; empty with a diagnostic.
std::vector<shot::MeshPtr> supports(const scene::Declaration& declaration, ReadContext& context) {
  std::vector<shot::MeshPtr> all;
  const auto targets = read_targets<shot::MeshOrLevelSet>(declaration, context, "mesh");
  for (size_t i = 0; i < targets.size(); ++i)
    for (const shot::MeshPtr& part : shot::parts_of(targets[i].mesh)) {
      for (const shot::MeshPtr& other : all)
        if (*part == *other) {
          context.diagnostics.error(declaration.target_at(i).where,
                                    "'" + part->name + "' is listed twice", "list it once");
          return {};
        }
      all.push_back(part);
    }
  return all;
}

/// The supporting meshes with the cell layer.
std::vector<shot::MeshPtr> meshes_with_cells(const shot::CellsPtr& cells) {
  std::vector<shot::MeshPtr> all;
  for (const shot::MeshPtr& bare : cells->on) {
    shot::MeshPlan plan = *bare;
    plan.support = all.size();
    plan.name = cells->on.size() == 1 ? cells->name : cells->name + "_" + bare->name;
    plan.cells = cells;
    all.push_back(std::make_shared<const shot::MeshPlan>(std::move(plan)));
  }
  return all;
}

/// Reports cells that cannot be scattered anew.
bool may_rescatter(const shot::CellsPlan& plan, ReadContext& context) {
  if (plan.rescatter == 0) return true;
  if (plan.on.size() == 1 && plan.on.front()->volume && plan.from.empty() && plan.move) return true;
  context.diagnostics.error(
      plan.where, "'rescatter' needs cells that move one mesh of a level set, without 'from'",
      "remove 'rescatter', 'from' or 'move false', or use one 'mesh NAME on VOLUME'");
  return false;
}

shot::MeshPtr combined(const std::string& name, const std::vector<shot::MeshPtr>& parts) {
  if (parts.size() == 1) return parts.front();
  shot::MeshPlan plan;
  plan.name = name;
  plan.parts = parts;
  return std::make_shared<const shot::MeshPlan>(std::move(plan));
}

}  // namespace

const DeclarationKind& cells_declaration() {
  static const DeclarationKind kind = {
      cells_schema().info(),
      [](const scene::Declaration& declaration, ReadContext& context) -> Value {
        std::optional<shot::CellsPlan> plan;
        Arguments arguments;
        bool still = false;
        if (has_block(declaration, context)) {
          arguments = arguments_of(declaration, context, still);
          plan = bind_block(cells_schema(), arguments, declaration, context);
        }
        const std::vector<shot::MeshPtr> on = supports(declaration, context);
        if (!plan || on.empty()) return Value();
        plan->name = declaration.name;
        plan->on = on;
        plan->key = context.evaluator.key(declaration);
        plan->inputs = inputs_of(declaration, context);
        plan->where = declaration.where;
        for (const Argument& each : arguments)
          if (each.name == "spacing") plan->spacing_where = each.where;
        plan->resumable = still && plan->rescatter == 0;
        shot::resolve_attribute_names(*plan, context.diagnostics);
        if (!may_rescatter(*plan, context)) return Value();
        const auto made = meshes_with_cells(shot::divide_run(std::move(*plan)));
        for (const shot::MeshPtr& mesh : made) context.shot.meshes.push_back(mesh);
        return Object{"mesh", combined(declaration.name, made)};
      },
      "mesh", true};
  return kind;
}

}  // namespace vug::loading
