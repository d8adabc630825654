// SPDX-License-Identifier: Apache-2.0
// Rendering, with options from Python.
#include "build.h"

#include <fmt/format.h>
#include <vug/base/diagnostics.h>

#include <cmath>
#include <map>

namespace vug::python {
namespace {

using picture::PictureOptions;

template <class T>
T read(const std::string& name, const py::handle& given, const std::string& meaning) {
  try {
    return given.cast<T>();
  } catch (const py::cast_error&) {
    throw py::type_error(fmt::format("{} must be {}", name, meaning));
  }
}

double number(const std::string& name, const py::handle& given, double low, double high) {
  const auto value = read<double>(name, given, "a number");
  if (!(value >= low && value <= high))
    throw py::value_error(fmt::format("{} must be from {} to {}, not {}", name, low, high, value));
  return value;
}

int whole(const std::string& name, const py::handle& given, int low) {
  const int value = read<int>(name, given, "an integer");
  if (value < low) throw py::value_error(fmt::format("{} must be at least {}", name, low));
  return value;
}

image::WorkingSpace space(const std::string& name) {
  std::vector<std::string> names;
  for (const image::WorkingSpaceInfo& each : image::working_spaces()) {
    if (each.name == name) return each.space;
    names.push_back(each.name);
  }
  throw py::value_error(
      fmt::format("unknown working space '{}'; {}", name, suggestion(name, names)));
}

int eye(const std::string& name) {
  if (name == "left") return -1;
  if (name == "right") return 1;
  throw py::value_error("eye must be 'left' or 'right'");
}

Vec2i size(const py::handle& given) {
  const auto both = read<std::pair<int, int>>("size", given, "two integers");
  if (both.first < 1 || both.second < 1) throw py::value_error("size must be at least 1 x 1");
  return {both.first, both.second};
}

std::vector<int> crop(const py::handle& given) {
  const auto box = read<std::array<int, 4>>("crop", given, "four integers");
  if (box[0] < 0 || box[1] < 0 || box[0] >= box[2] || box[1] >= box[3])
    throw py::value_error("crop must be left, top, right, bottom; right and bottom are exclusive");
  return {box.begin(), box.end()};
}

using Setter = void (*)(PictureOptions&, const std::string&, const py::handle&);

template <bool PictureOptions::*member>
void flag(PictureOptions& o, const std::string& name, const py::handle& given) {
  if (!py::isinstance<py::bool_>(given)) throw py::type_error(name + " must be True or False");
  o.*member = given.cast<bool>();
}
template <std::string PictureOptions::*member>
void text(PictureOptions& o, const std::string& name, const py::handle& given) {
  o.*member = read<std::string>(name, given, "a string");
}

const std::map<std::string, Setter>& setters() {
  using P = PictureOptions;
  static const std::map<std::string, Setter> all = {
      {"camera", text<&P::camera>},
      {"view", text<&P::view>},
      {"display", text<&P::display>},
      {"denoise", flag<&P::denoise>},
      {"deep", flag<&P::deep>},
      {"full_float", flag<&P::full_float>},
      {"multi_part", flag<&P::multi_part>},
      {"tiled", flag<&P::tiled>},
      {"size", [](P& o, const std::string&, const py::handle& v) { o.size = size(v); }},
      {"crop", [](P& o, const std::string&, const py::handle& v) { o.crop = crop(v); }},
      {"spp", [](P& o, const std::string& n, const py::handle& v) { o.spp = whole(n, v, 1); }},
      {"seed",
       [](P& o, const std::string& n, const py::handle& v) {
         o.seed = read<uint64_t>(n, v, "an integer of at least 0");
       }},
      {"noise",
       [](P& o, const std::string& n, const py::handle& v) { o.noise = number(n, v, 0, 1); }},
      {"exposure",
       [](P& o, const std::string& n, const py::handle& v) { o.exposure = number(n, v, -30, 30); }},
      {"layers",
       [](P& o, const std::string& n, const py::handle& v) {
         o.layers = py::isinstance<py::str>(v)
                        ? std::vector{v.cast<std::string>()}
                        : read<std::vector<std::string>>(n, v, "names of layers");
       }},
      {"eye",
       [](P& o, const std::string& n, const py::handle& v) {
         o.eye = eye(read<std::string>(n, v, "'left' or 'right'"));
       }},
      {"working_space",
       [](P& o, const std::string& n, const py::handle& v) {
         o.working_space = space(read<std::string>(n, v, "a name"));
       }},
      {"ocio", [](P& o, const std::string& n, const py::handle& v) {
         o.config = read<std::filesystem::path>(n, v, "a file");
       }}};
  return all;
}

}  // namespace

picture::RenderOptions render_options(const Scene& scene, const py::kwargs& given) {
  picture::RenderOptions options;
  options.picture.config = image::environment_config();
  options.picture.seed = scene.settings().load.seed;
  for (const auto& [key, value] : given) {
    const auto name = key.cast<std::string>();
    if (name == "checkpoint" && !value.is_none()) {
      options.checkpoint = read<std::filesystem::path>(name, value, "a file");
      options.resume = true;
      continue;
    }
    const auto setter = setters().find(name);
    if (setter == setters().end()) {
      std::vector<std::string> names = {"checkpoint"};
      for (const auto& each : setters()) names.push_back(each.first);
      throw py::type_error(
          fmt::format("render: unknown option '{}'; {}", name, suggestion(name, names)));
    }
    if (!value.is_none()) setter->second(options.picture, name, value);
  }
  options.picture.shot_at_frame = scene.shot_at_frame();
  return options;
}

Image render(Build& build, const picture::RenderOptions& options) {
  auto rendered = std::make_shared<std::vector<picture::RenderResult>>();
  build.work([&](building::Builder& builder) {
    *rendered = picture::render_views(builder, options);
    picture::warn_about_exposure(builder, rendered->front());
  });
  return {rendered, {}, options.checkpoint};
}

}  // namespace vug::python
