// SPDX-License-Identifier: Apache-2.0
#include <vug/render/kinds.h>
#include <vug/shot/render_settings.h>

#include <algorithm>
#include <cstdlib>

namespace vug::shot {
namespace {

/// A table that collects the values of the settings.
template <class Settings>
class ValueTable {
 public:
  explicit ValueTable(const Settings& settings) : settings_(settings) { Settings::describe(*this); }
  NamedValues values;

  ValueTable& doc(const std::string&) { return *this; }
  template <class T, class Base>
  ValueTable& param(const std::string& name, T Base::*member, const ParamSpec&) {
    values.emplace_back(name, ValueTraits<T>::write(settings_.*member));
    return *this;
  }
  template <class T, class Base>
  ValueTable& number_or_name(const std::string& name, T Base::*member,
                             const std::vector<std::string>&, const ParamSpec& spec) {
    return param(name, member, spec);
  }
  template <class E>
  ValueTable& choice(const std::string& name, E Settings::*member,
                     const std::vector<std::pair<std::string, E>>& names, const std::string&) {
    for (const auto& [text, value] : names)
      if (value == settings_.*member) values.emplace_back(name, Value::Name{text});
    return *this;
  }

 private:
  const Settings& settings_;
};

template <class Settings>
Schema<Settings> make_schema() {
  Schema<Settings> schema("render", "declaration");
  Settings::describe(schema);
  return schema;
}

template <class Settings>
Settings bind_values(const Schema<Settings>& schema, const NamedValues& values) {
  Arguments arguments;
  for (const auto& [name, value] : values)
    if (!value.empty()) arguments.push_back({name, value, {}});
  Diagnostics diagnostics;
  std::optional<Settings> settings = schema.bind(arguments, {}, diagnostics);
  if (settings) return std::move(*settings);
  const Diagnostic& first = diagnostics.all().front();
  throw Error(ErrorCode::bad_input, first.message, {}, first.hint);
}

std::string to_text(const Value& value) {
  const std::string* text = value.get<std::string>();
  return text ? *text : to_string(value);
}

Value from_text(const ParamInfo& info, const std::string& text) {
  if (info.type == "true or false") return text == "true";
  if (info.type == "name") return Value::Name{text};
  if (info.type == "text") return text;
  if (std::find(info.choices.begin(), info.choices.end(), text) != info.choices.end())
    return Value::Name{text};
  return std::strtod(text.c_str(), nullptr);
}

}  // namespace

std::vector<std::pair<std::string, image::WorkingSpace>> working_space_names() {
  std::vector<std::pair<std::string, image::WorkingSpace>> names;
  for (const image::WorkingSpaceInfo& each : image::working_spaces())
    names.emplace_back(each.name, each.space);
  return names;
}

const Schema<RenderSettings>& render_schema() {
  static const Schema<RenderSettings> schema = make_schema<RenderSettings>();
  return schema;
}

std::optional<SettingFault> find_fault(const RenderSettings& settings) {
  if (settings.size.size() != 2)
    return SettingFault{"size", "'size' must be a width and a height", "size 1920x1080"};
  if (!settings.crop.empty() && settings.crop.size() != 4)
    return SettingFault{"crop", "'crop' must be left, top, right and bottom",
                        "crop [0, 0, 960, 540]"};
  return std::nullopt;
}

RenderSettings with_overrides(const RenderSettings& settings, const NamedValues& overrides) {
  NamedValues values = ValueTable(settings).values;
  for (const auto& each : overrides) {
    const auto same = std::find_if(values.begin(), values.end(),
                                   [&](const auto& known) { return known.first == each.first; });
    if (same == values.end())
      values.push_back(each);
    else
      same->second = each.second;
  }
  RenderSettings changed = bind_values(render_schema(), values);
  if (const auto fault = find_fault(changed))
    throw Error(ErrorCode::bad_input, fault->message, {}, fault->hint);
  return changed;
}

NamedTexts to_texts(const OutputSettings& settings) {
  NamedTexts texts;
  for (const auto& [name, value] : ValueTable(settings).values)
    texts.emplace_back(name, to_text(value));
  return texts;
}

OutputSettings from_texts(const NamedTexts& texts) {
  static const Schema<OutputSettings> schema = make_schema<OutputSettings>();
  NamedValues values;
  for (const ParamInfo& info : schema.info().params)
    for (const auto& [name, text] : texts)
      if (name == info.name) values.emplace_back(name, from_text(info, text));
  return bind_values(schema, values);
}

}  // namespace vug::shot
