#include <vug/session/reader.h>
#include <vug/session/stages.h>

#include <algorithm>

namespace vug::session {
namespace {

Schema<CellsPlan> schema() {
  Schema<CellsPlan> s("cells", "declaration");
  ParamSpec spacing = positive_length("from one cell to the next");
  spacing.required = true;
  s.doc(
       "The mesh with what a network of cells on it has come to carry, as attributes of its "
       "vertices: cells NAME on MESH { spacing 2cm  run RULE, RULE(...) }.")
      .cite("gobron2006")
      .param("spacing", &CellsPlan::spacing, spacing)
      .param("grid", &CellsPlan::grid, {.doc = "the pattern of the cells; random if not given"})
      .param("relax", &CellsPlan::relax,
             {.doc = "steps in which cells push each other apart; the grid's own number if not "
                     "given",
              .min = 0,
              .max = 1000})
      .param("run", &CellsPlan::run,
             {.doc = "rules, with begin, steps and where; in a step each after those before it",
              .required = true})
      .param("steps", &CellsPlan::steps,
             {.doc = "of the whole run; if not given, as many as rules need: those that work to "
                     "the end 100 each",
              .min = 0,
              .max = 1000000});
  return s;
}

/// The values of an entry that names kinds of a family.
Value kinds_of(const std::string& type, const scene::Entry& entry, RandomKey key,
               Reading& reading) {
  List all;
  for (const scene::ExprPtr& expr : entry.values)
    all.push_back(kind_value(*find_family(type), *expr, key.at(entry.key).at(all.size()), reading));
  if (std::any_of(all.begin(), all.end(), [](const Value& each) { return each.empty(); }))
    return Value();
  return all.size() == 1 ? all[0] : Value(std::move(all));
}

Arguments arguments_of(const scene::Declaration& declaration, Reading& reading) {
  const auto type_of = [](const scene::Entry& entry) -> std::string {
    return entry.key == "run" ? "rule" : entry.key == "grid" ? "grid" : "";
  };
  scene::Declaration plain = declaration;
  plain.entries.clear();
  Arguments arguments;
  for (const scene::Entry& entry : declaration.entries) {
    if (type_of(entry).empty())
      plain.entries.push_back(entry);
    else
      arguments.push_back(
          {entry.key, kinds_of(type_of(entry), entry, reading.evaluator.key(declaration), reading),
           entry.where});
  }
  const auto none = [](const std::string&, const std::string&) { return false; };
  for (Argument& each : block_arguments(plain, none, reading)) {
    const Number* number = each.value.get<Number>();
    if (each.name == "spacing" && number && !(number->value > 0)) {
      reading.diagnostics.error(each.where, "the spacing of cells is a length above 0",
                                "for instance: spacing 2cm");
      each.value = Value();
    }
    arguments.push_back(std::move(each));
  }
  return arguments;
}

/// Tells how a level set gets cells.
bool refuse_volume(const scene::Declaration& declaration, Reading& reading) {
  if (declaration.value || !declaration.target) return false;
  const Value value = target_value("mesh", declaration, reading);
  if (!value.object<VolumePtr>()) return false;
  reading.diagnostics.error(declaration.target->where, "cells stand on a mesh, not on a volume",
                            "mesh NAME on " + declaration.target->text + " {}");
  return true;
}

}  // namespace

const DeclarationKind& cells_declaration() {
  static const DeclarationKind kind = {
      schema().info(),
      [](const scene::Declaration& declaration, Reading& reading) -> Value {
        std::optional<CellsPlan> plan;
        Arguments arguments;
        if (has_block(declaration, reading)) {
          arguments = arguments_of(declaration, reading);
          plan = bind_block(schema(), arguments, declaration, reading);
        }
        if (refuse_volume(declaration, reading)) return Value();
        const MeshPtr bare = read_target<MeshPtr>(declaration, reading);
        if (!plan || !bare) return Value();
        plan->name = declaration.name;
        plan->key = reading.evaluator.key(declaration);
        plan->where = declaration.where;
        for (const Argument& each : arguments)
          if (each.name == "spacing") plan->spacing_where = each.where;
        plan->on = bare;
        MeshPlan worn = *bare;
        worn.name = declaration.name;
        worn.cells = std::make_shared<const CellsPlan>(std::move(*plan));
        const MeshPtr made = std::make_shared<const MeshPlan>(std::move(worn));
        reading.shot.meshes.push_back(made);
        return Object{"mesh", made};
      },
      "mesh"};
  return kind;
}

}  // namespace vug::session
