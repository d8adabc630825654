// SPDX-License-Identifier: Apache-2.0
#include "setting_options.h"

#include "arguments.h"

#include <fmt/format.h>
#include <vug/base/error.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace vug::cli {
namespace {

/// "--working-space" for the setting `working_space`.
std::string option_name(const ParamInfo& info) {
  std::string name = "--" + info.name;
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

/// The documentation of the setting as help text.
std::string help_text(const ParamInfo& info) {
  std::string text = info.doc;
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  if (info.fallback == "true") text += fmt::format("; {}=false switches it off", option_name(info));
  return text;
}

List to_list(const std::vector<int>& numbers) { return List(numbers.begin(), numbers.end()); }

}  // namespace

void SettingOptions::add(CLI::App& app, const ParamInfo& info) {
  const std::string name = option_name(info), help = help_text(info);
  const auto keep = [this, setting = info.name](Value value) {
    given_.emplace_back(setting, std::move(value));
  };
  const auto add_text = [&](auto to_value) {
    return app.add_option_function<std::string>(
        name, [=](const std::string& text) { keep(to_value(text)); }, help);
  };
  const auto to_number = [](const std::string& text) { return std::strtod(text.c_str(), nullptr); };
  if (info.type == "true or false")
    app.add_flag_function(
        name, [=](int64_t count) { keep(count > 0); }, help);
  if (info.type == "number")
    add_text(to_number)->transform(number_in(info.dimension, info.min, info.max));
  if (info.type == "number or name")
    add_text([to_number, names = info.choices](const std::string& text) -> Value {
      if (std::find(names.begin(), names.end(), text) != names.end()) return Value::Name{text};
      return to_number(text);
    })->transform(number_or_name(info));
  if (info.type == "whole number")
    add_text(to_number)->check(integer_in(static_cast<int>(info.min), static_cast<int>(info.max)));
  if (info.type == "text") add_text([](const std::string& text) { return text; });
  if (info.type == "name")
    add_text([](const std::string& text) {
      return Value::Name{text};
    })->check(CLI::IsMember(info.choices));
  if (info.type == "list of text")
    app.add_option_function<std::vector<std::string>>(
           name,
           [=](const std::vector<std::string>& texts) { keep(List(texts.begin(), texts.end())); },
           help)
        ->delimiter(',');
}

void SettingOptions::add_to(CLI::App& app) {
  app.add_option("--size", size_, "Size of the picture, WIDTHxHEIGHT in pixels");
  app.add_option("--crop", crop_,
                 "Crop window, LEFT,TOP,RIGHT,BOTTOM in pixels; right and bottom are exclusive");
  app.add_flag("--float", full_float_, "32-bit colour channels in the EXR");
  for (const ParamInfo& info : shot::render_schema().info().params)
    if (info.name != "half" && info.name != "quality") add(app, info);
}

NamedValues SettingOptions::values() const {
  NamedValues values = given_;
  if (full_float_) values.emplace_back("half", false);
  if (!size_.empty()) {
    const auto size = parse_numbers(size_, "NxN", "size", "write --size 1920x1080");
    if (size[0] < 1 || size[1] < 1)
      throw Error(ErrorCode::bad_input,
                  fmt::format("invalid size '{}': width and height must be at least 1", size_), {},
                  "write --size 1920x1080");
    values.emplace_back("size", to_list(size));
  }
  if (!crop_.empty()) values.emplace_back("crop", to_list(parse_crop(crop_)));
  return values;
}

}  // namespace vug::cli
