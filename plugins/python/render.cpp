// SPDX-License-Identifier: Apache-2.0
// Rendering, with options from Python.
#include "build.h"
#include "errors.h"

#include <fmt/format.h>
#include <vug/base/diagnostics.h>
#include <vug/loading/placement/check.h>
#include <vug/picture/render_choice.h>

#include <algorithm>

namespace vug::python {
namespace {

template <class T>
T read(const std::string& name, const py::handle& given, const std::string& meaning) {
  try {
    return given.cast<T>();
  } catch (const py::cast_error&) {
    throw py::type_error(fmt::format("{} must be {}", name, meaning));
  }
}

Value number(const ParamInfo& info, const py::handle& given) {
  const auto value = read<double>(info.name, given, "a number");
  if (!(value >= info.min && value <= info.max))
    throw py::value_error(
        fmt::format("{} must be from {} to {}, not {}", info.name, info.min, info.max, value));
  return value;
}

Value whole_number(const ParamInfo& info, const py::handle& given) {
  const int value = read<int>(info.name, given, "an integer");
  if (value < info.min)
    throw py::value_error(fmt::format("{} must be at least {}", info.name, info.min));
  if (value > info.max)
    throw py::value_error(fmt::format("{} must be at most {}", info.name, info.max));
  return value;
}

Value name_of_choice(const ParamInfo& info, const py::handle& given) {
  const auto name = read<std::string>(info.name, given, "a name");
  if (std::find(info.choices.begin(), info.choices.end(), name) == info.choices.end())
    throw py::value_error(
        fmt::format("unknown {} '{}'; {}", info.name, name, suggestion(name, info.choices)));
  return Value::Name{name};
}

Value truth(const std::string& name, const py::handle& given) {
  if (!py::isinstance<py::bool_>(given)) throw py::type_error(name + " must be True or False");
  return given.cast<bool>();
}

Value texts(const std::string& name, const py::handle& given) {
  const auto all = py::isinstance<py::str>(given)
                       ? std::vector{given.cast<std::string>()}
                       : read<std::vector<std::string>>(name, given, "a list of names");
  return List(all.begin(), all.end());
}

Value size(const py::handle& given) {
  const auto both = read<std::pair<int, int>>("size", given, "two integers");
  if (both.first < 1 || both.second < 1) throw py::value_error("size must be at least 1 x 1");
  return List{both.first, both.second};
}

Value crop(const py::handle& given) {
  const auto box = read<std::array<int, 4>>("crop", given, "four integers");
  if (box[0] < 0 || box[1] < 0 || box[0] >= box[2] || box[1] >= box[3])
    throw py::value_error("crop must be left, top, right, bottom; right and bottom are exclusive");
  return List(box.begin(), box.end());
}

/// The value of a setting; nothing for a setting that is an object.
std::optional<Value> setting_value(const ParamInfo& info, const py::handle& given) {
  if (info.name == "size") return size(given);
  if (info.name == "crop") return crop(given);
  if (info.type == "true or false") return truth(info.name, given);
  if (info.type == "number") return number(info, given);
  if (info.type == "number or name")
    return py::isinstance<py::str>(given) ? name_of_choice(info, given) : number(info, given);
  if (info.type == "whole number") return whole_number(info, given);
  if (info.type == "text") return read<std::string>(info.name, given, "a string");
  if (info.type == "name") return name_of_choice(info, given);
  if (info.type == "list of text") return texts(info.name, given);
  return std::nullopt;
}

int eye(const std::string& name) {
  if (name == "left") return -1;
  if (name == "right") return 1;
  throw py::value_error("eye must be 'left' or 'right'");
}

/// Applies an argument that is not a setting of the table; false for an unknown name.
bool apply_other(RenderArguments& arguments, const std::string& name, const py::handle& given) {
  picture::PictureOptions& picture = arguments.picture;
  if (name == "camera")
    picture.camera = read<std::string>(name, given, "a string");
  else if (name == "seed")
    picture.seed = read<uint64_t>(name, given, "an integer of at least 0");
  else if (name == "eye")
    picture.eye = eye(read<std::string>(name, given, "'left' or 'right'"));
  else if (name == "ocio")
    picture.config = read<std::filesystem::path>(name, given, "a file");
  else if (name == "anyway")
    arguments.anyway = *truth(name, given).get<bool>();
  else if (name == "full_float")
    picture.settings.emplace_back("half", !*truth(name, given).get<bool>());
  else if (name == "checkpoint") {
    arguments.render.checkpoint = read<std::filesystem::path>(name, given, "a file");
    arguments.render.resume = true;
  } else {
    return false;
  }
  return true;
}

[[noreturn]] void refuse_unknown(const std::string& name) {
  std::vector<std::string> names = {"camera", "seed",       "eye",       "ocio",
                                    "anyway", "full_float", "checkpoint"};
  for (const ParamInfo& info : shot::render_schema().info().params) names.push_back(info.name);
  throw py::type_error(
      fmt::format("render: unknown option '{}'; {}", name, suggestion(name, names)));
}

void apply(RenderArguments& arguments, const std::string& name, const py::handle& given) {
  for (const ParamInfo& info : shot::render_schema().info().params) {
    if (info.name != name) continue;
    if (const auto value = setting_value(info, given))
      return arguments.picture.settings.emplace_back(name, *value), void();
  }
  if (!apply_other(arguments, name, given)) refuse_unknown(name);
}

}  // namespace

RenderArguments render_arguments(const Scene& scene, const std::string& name,
                                 const py::kwargs& given) {
  RenderArguments arguments;
  arguments.picture.render =
      picture::choose_renders(scene.shot(),
                              name.empty() ? std::vector<std::string>() : std::vector{name})
          .front();
  arguments.picture.config = image::environment_config();
  arguments.picture.seed = scene.settings().load.seed;
  arguments.picture.source = &scene.source();
  for (const auto& [key, value] : given) {
    if (!value.is_none()) apply(arguments, key.cast<std::string>(), value);
  }
  return arguments;
}

std::string render_doc() {
  std::string doc =
      "Renders a render block and returns a vug.Image. `name` is required if the scene has\n"
      "several. Arguments replace the settings of the block, and choose the view of the scene:\n\n";
  for (const ParamInfo& info : shot::render_schema().info().params)
    doc += fmt::format("{}: {}\n", info.name, info.doc);
  return doc +
         "full_float: store colours as 32-bit floats\n"
         "seed: seed of the samples\n"
         "eye: view of a stereo camera, 'left' or 'right'\n"
         "ocio: OpenColorIO configuration, a file\n"
         "anyway: render even if the camera or a light is in rock, a prop floats or a void is\n"
         "filled, which otherwise is an error\n"
         "checkpoint: file of the unfinished picture; if it exists, rendering continues from it,\n"
         "and Image.save to an EXR removes it";
}

Image render(Build& build, const RenderArguments& arguments) {
  auto rendered = std::make_shared<std::vector<picture::RenderResult>>();
  const loading::Loaded& scene = build.scene()->loaded();
  Diagnostics mistakes;
  build.work([&](building::Builder& builder) {
    const picture::PicturePlan plan = picture::plan_picture(builder.shot(), arguments.picture);
    if (!arguments.anyway && &builder.shot() == &scene.shot)
      loading::check_placement(scene,
                               {picture::camera_name(scene.shot, plan.render),
                                loading::Accuracy::exact, plan.shown.get()},
                               mistakes);
    if (mistakes.has_errors()) return;
    *rendered = picture::render_views(builder, plan, arguments.render);
    picture::warn_about_exposure(builder, rendered->front());
  });
  if (mistakes.has_errors()) raise(scene, mistakes);
  return {rendered, {}, arguments.render.checkpoint};
}

}  // namespace vug::python
