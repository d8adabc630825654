// SPDX-License-Identifier: Apache-2.0
// Scenes: loading, overrides and declarations.
#include "scene.h"

#include "errors.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/delivery/recipe.h>
#include <vug/loading/data_folders.h>
#include <vug/loading/dependencies.h>
#include <vug/shot/queries.h>

#include <algorithm>
#include <string_view>

namespace vug::python {
namespace {

using SharedScene = std::shared_ptr<Scene>;
using Seed = std::optional<uint64_t>;
using Frame = std::optional<double>;
using Name = std::optional<std::string>;

/// Adds overrides for these parameters.
void set_parameters(LoadSettings& settings, const py::dict& changes) {
  std::vector<scene::Override>& all = settings.load.overrides;
  for (const auto& [key, value] : changes) {
    if (!py::isinstance<py::str>(key)) throw py::type_error("names of parameters must be strings");
    const auto name = key.cast<std::string>();
    const std::string text = override_text(name, value);
    const auto known = std::find_if(all.begin(), all.end(),
                                    [&](const scene::Override& each) { return each.name == name; });
    if (known == all.end())
      all.push_back({name, text});
    else
      known->text = text;
    settings.numbers.erase(name);
    if (!py::isinstance<py::str>(value)) settings.numbers.insert(name);
  }
}

/// The arguments of a scene that are not parameters; without a value, nothing changes.
struct Choices {
  Seed seed;
  Frame frame;
  Name variant;
};

LoadSettings with_changes(LoadSettings settings, const py::dict& params, const Choices& choices,
                          const py::kwargs& more) {
  if (choices.seed) settings.load.seed = choices.seed;
  if (choices.frame) settings.load.frame = *choices.frame;
  if (choices.variant) settings.load.variant = *choices.variant;
  if (!(std::fabs(settings.load.frame) <= 1e6))
    throw py::value_error("frame must be from -1e6 to 1e6");
  set_parameters(settings, params);
  set_parameters(settings, more);
  return settings;
}

LoadSettings default_settings() {
  LoadSettings settings;
  settings.load.include_folders = loading::data_folders();
  return settings;
}

/// Appends the unit to overrides of angles, which are in radians in Python and need a unit in a
/// scene text. Returns whether there are any.
bool add_angle_units(LoadSettings& settings, const loading::Loaded& loaded) {
  bool given = false;
  for (scene::Override& each : settings.load.overrides)
    for (const loading::Parameter& param : loaded.parameters) {
      const Number* number = param.fallback.get<Number>();
      if (param.name != each.name || !number || number->dimension != Dimension::angle) continue;
      if (settings.numbers.erase(each.name) == 0) continue;
      each.text += "rad";
      given = true;
    }
  return given;
}

SharedScene load(const std::filesystem::path& file, const py::dict& params, const Seed& seed,
                 const Frame& frame, const Name& variant, const py::kwargs& more) {
  return std::make_shared<Scene>(
      read_text(file), file.string(),
      with_changes(default_settings(), params, {seed, frame, variant}, more));
}

SharedScene loads(const std::string& text, const std::filesystem::path& base,
                  const std::string& name, const py::dict& params, const Seed& seed,
                  const Frame& frame, const Name& variant, const py::kwargs& more) {
  const std::filesystem::path file = base == "." ? std::filesystem::path(name) : base / name;
  return std::make_shared<Scene>(
      text, file.string(), with_changes(default_settings(), params, {seed, frame, variant}, more));
}

/// The scene from which a file was built. The frame is not part of the text, but an argument in the
/// recipe.
SharedScene scene_of(const std::filesystem::path& file, const std::filesystem::path& base) {
  const delivery::Recipe recipe = delivery::read_recipe(file);
  Frame frame;
  for (const std::string& argument : recipe.arguments)
    if (constexpr std::string_view kFrame = "--frame "; argument.rfind(kFrame, 0) == 0)
      frame = std::stod(argument.substr(kFrame.size()));
  return loads(recipe.scene, base, file.stem().string() + ".vug", py::dict(), std::nullopt, frame,
               std::nullopt, py::kwargs());
}

SharedScene change(const Scene& scene, const py::dict& params, const Seed& seed, const Frame& frame,
                   const Name& variant, const py::kwargs& more) {
  return std::make_shared<Scene>(
      scene.text(), scene.file(),
      with_changes(scene.settings(), params, {seed, frame, variant}, more));
}

SharedScene append(const Scene& scene, const std::string& statements) {
  LoadSettings settings = scene.settings();
  settings.load.appended.push_back(statements);
  return std::make_shared<Scene>(scene.text(), scene.file(), std::move(settings));
}

py::object evaluate(const Scene& scene, const std::string& expression) {
  if (expression.find_first_not_of(" \t\r\n") == std::string::npos)
    throw py::value_error("the expression is empty: write a value of the scene language");
  loading::Loaded loaded;
  {
    const py::gil_scoped_release others;
    loaded = scene.source().evaluate(expression, scene.settings().load.frame);
  }
  if (!loaded.usable()) raise(loaded, loaded.diagnostics);
  return to_plain_python(loaded.value);
}

py::dict functions(const Scene& scene) {
  const py::module_ types = py::module_::import("vug._functions");
  py::dict out;
  for (const KindInfo& each : scene.loaded().functions) {
    py::dict parameters;
    for (const ParamInfo& param : each.params)
      parameters[py::str(param.name)] =
          types.attr("FunctionParam")(param.name, param.doc, param.required);
    out[py::str(each.name)] = types.attr("Function")(each.name, each.doc, parameters);
  }
  return out;
}

py::dict variants(const Scene& scene) {
  py::dict out;
  for (const loading::Variant& each : scene.loaded().variants) {
    py::dict values;
    for (const auto& [name, value] : each.values) values[py::str(name)] = to_python(value);
    out[py::str(each.name)] = values;
  }
  return out;
}

py::dict params(const Scene& scene) {
  const py::object type = py::module_::import("vug._params").attr("Param");
  py::dict out;
  for (const loading::Parameter& each : scene.loaded().parameters) {
    const Number* number = each.fallback.get<Number>();
    const auto* vector = each.fallback.get<Value::Vector>();
    const Dimension dimension = number   ? number->dimension
                                : vector ? vector->dimension
                                         : Dimension::none;
    std::string kind = each.fallback.get<Value::Name>() ? "name" : each.fallback.type_name();
    if (number) kind = "number";
    for (const std::string article : {"a ", "an "})
      if (kind.rfind(article, 0) == 0) kind = kind.substr(article.size());
    out[py::str(each.name)] = type(each.name, to_python(each.value), to_python(each.fallback),
                                   to_python(each.low), to_python(each.high), each.doc, kind,
                                   dimension == Dimension::none ? "" : to_string(dimension));
  }
  return out;
}

std::vector<std::filesystem::path> files(const Scene& scene) {
  std::vector<std::filesystem::path> out = loading::file_dependencies(scene.loaded());
  std::sort(out.begin(), out.end());
  return out;
}

py::dict derivations(const SharedScene& scene) {
  py::dict out;
  for (const shot::Derivation& each : scene->shot().derivations)
    out[py::str(each.name)] = Derivation{scene, &each};
  return out;
}

template <class Plan>
const std::string& name_of_plan(const Plan& plan) {
  if constexpr (requires { plan->name; })
    return plan->name;
  else if constexpr (requires { plan.name; })
    return plan.name;
  else
    return plan.first;
}

/// Getter of the names in one of the shot's lists, in the order of the text.
template <class List>
auto names(List shot::Shot::*list) {
  return [list](const Scene& scene) {
    std::vector<std::string> out;
    for (const auto& each : scene.shot().*list) out.push_back(name_of_plan(each));
    return out;
  };
}

template <class Plans>
std::vector<std::string> names_of(const Plans& plans) {
  std::vector<std::string> out;
  for (const auto& each : plans) out.push_back(each->name);
  return out;
}

void bind_names(py::class_<Scene, SharedScene>& type) {
  using shot::Shot;
  type.def_property_readonly("volumes", names(&Shot::volumes), "Names of the volumes.")
      .def_property_readonly(
          "meshes", [](const Scene& s) { return names_of(shot::shown_meshes(s.shot())); },
          "Names of the declared meshes, or of one mesh per level set if none is declared.")
      .def_property_readonly(
          "cells", [](const Scene& s) { return names_of(shot::declared_cells(s.shot())); })
      .def_property_readonly("objects", names(&Shot::objects))
      .def_property_readonly("places", names(&Shot::instancers))
      .def_property_readonly("lights", names(&Shot::lights))
      .def_property_readonly("materials", names(&Shot::materials))
      .def_property_readonly("cameras", names(&Shot::cameras))
      .def_property_readonly("renders", names(&Shot::renders));
}

}  // namespace

Scene::Scene(std::string text, std::string file, LoadSettings settings)
    : settings_(std::move(settings)) {
  const auto reload = [&] {
    source_ = std::make_unique<const loading::SceneSource>(text, file, settings_.load);
    loaded_ = source_->at(settings_.load.frame);
  };
  {
    const py::gil_scoped_release others;
    reload();
    if (!loaded_.usable() && add_angle_units(settings_, loaded_)) reload();
  }
  if (!loaded_.usable()) raise(loaded_, loaded_.diagnostics);
  warn(warnings_of(loaded_, loaded_.diagnostics));
}

void bind_scene(py::module_& module) {
  py::class_<Scene, SharedScene> type(
      module, "Scene",
      "An immutable scene: a text with values of its parameters, a seed and a frame. `with_`\n"
      "returns a modified scene. Created by vug.load and vug.loads.");
  type.def("with_", &change, "params"_a = py::dict(), py::kw_only(), "seed"_a = py::none(),
           "frame"_a = py::none(), "variant"_a = py::none(),
           "Returns the scene with other parameters, by name or in a dict: scene.with_(LD=3). "
           "Other\n"
           "values are kept. Numbers are in metres or radians or have no unit; a str is text of "
           "the\n"
           "scene language: '30%', '2m', '45deg'. variant: a variant of the scene, over which\n"
           "parameters take precedence; '' for none.")
      .def("with_text", &append, "statements"_a,
           "Returns the scene with statements appended to its text, such as\n"
           "scene.with_text('volume slabs = level_set(slab((0, 0, 0)), voxel: 5cm)'). Errors in "
           "them\n"
           "name the file 'appended' ('appended 2', ... for further texts).")
      .def("evaluate", &evaluate, "expression"_a,
           "Returns the value of an expression of the scene language with the names of the scene:\n"
           "scene.evaluate('len(spots)'). Numbers are in metres and radians, vectors are tuples, "
           "lists\n"
           "are lists. Objects, such as solids and lights, raise a TypeError.")
      .def_property_readonly("functions", &functions,
                             "vug.Function by name, with doc and parameters; in the order of the "
                             "text. Those of modules\n"
                             "have its prefix. A call returns the text of the call: "
                             "scene.functions['slab']((0, 1, 0)).")
      .def_property_readonly(
          "variants", &variants,
          "The variants of the scene: dicts of parameter values by the name of the variant.")
      .def_property_readonly(
          "variant", [](const Scene& s) { return s.settings().load.variant; },
          "The name of the chosen variant; empty: none.")
      .def_property_readonly(
          "params", &params,
          "vug.Param by name, with value, range and doc; in the order of the text.")
      .def_property_readonly("derivations", &derivations,
                             "vug.Derivation by the name of its grammar.")
      .def_property_readonly(
          "name", [](const Scene& s) { return s.shot().name; },
          "The file name without its extension.")
      .def_property_readonly("file", &Scene::file)
      .def_property_readonly(
          "files", &files,
          "Paths of all input files: scene texts, and the meshes, grids and pictures they use.")
      .def_property_readonly(
          "text",
          [](const Scene& s) { return loading::joined_text(s.text(), s.settings().load.appended); },
          "The text, with the statements that were appended.")
      .def_property_readonly("seed", [](const Scene& s) { return s.shot().seed; })
      .def_property_readonly("frame", [](const Scene& s) { return s.shot().frame; })
      .def_property_readonly(
          "moves", [](const Scene& s) { return s.shot().animated; },
          "Whether the scene depends on the frame.")
      .def_property_readonly(
          "recipe", [](const Scene& s) { return s.shot().recipe; },
          "The text with all overrides, which files contain as their origin.")
      .def("__repr__", [](const Scene& s) {
        return fmt::format("<vug.Scene '{}', seed {}>", s.shot().name, s.shot().seed);
      });
  bind_names(type);
  module.def(
      "load", &load, "file"_a, "params"_a = py::dict(), py::kw_only(), "seed"_a = py::none(),
      "frame"_a = py::none(), "variant"_a = py::none(),
      "Loads the scene of a .vug file, with parameters by name or in a dict:\n"
      "vug.load('grotto.vug', LD=3, seed=7). `variant` is the name of a variant of the scene, "
      "over\n"
      "which parameters take precedence. Raises vug.Error with all errors of the text.");
  module.def("loads", &loads, "text"_a, "base"_a = ".", "name"_a = "scene.vug",
             "params"_a = py::dict(), py::kw_only(), "seed"_a = py::none(), "frame"_a = py::none(),
             "variant"_a = py::none(),
             "Loads a scene from a text. Files are searched relative to the folder `base`, and\n"
             "messages call the text `name`.");
  module.def("argument_text", &argument_text, "name"_a, "value"_a,
             "The text of an argument of a function in the scene language.");
  module.def(
      "scene_of", &scene_of, "file"_a, "base"_a = ".",
      "Loads the scene from which a file was built: a .vdb, mesh, picture or exported file. Files\n"
      "that its text uses are searched relative to the folder `base`.");
}

}  // namespace vug::python
