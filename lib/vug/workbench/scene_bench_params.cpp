// SPDX-License-Identifier: Apache-2.0
// The params of the scene bench: changed values and presets.
#include <vug/base/error.h>
#include <vug/language/edits.h>
#include <vug/loading/data_folders.h>
#include <vug/workbench/scene_bench.h>

#include <fmt/format.h>

namespace vug::workbench {

std::optional<std::string> SceneBench::saved_param(const std::string& name) const {
  require_document();
  if (saved_params_of_ != file_.text()) {
    language::Workspace draft({loading::data_folders()});
    draft.open(file(), *file_.text());
    saved_params_.clear();
    for (const language::ParamSetting& each : language::params_of(*draft.analyse(file())))
      saved_params_[each.name] = each.text;
    saved_params_of_ = file_.text();
  }
  const auto found = saved_params_.find(name);
  return found == saved_params_.end() ? std::nullopt : std::optional(found->second);
}

bool SceneBench::is_changed(const language::ParamSetting& param) const {
  const std::optional<std::string> saved = saved_param(param.name);
  return saved && *saved != param.text;
}

void SceneBench::reset_param(const std::string& name) {
  param(name);
  const std::optional<std::string> saved = saved_param(name);
  if (!saved)
    throw Error(ErrorCode::bad_input,
                fmt::format("the saved text does not declare the param '{}'", name), {},
                "save the text first, or set a value");
  const std::string after =
      language::apply(text(), {language::set_param(*analysis(), name, *saved)});
  edit_recorded(change_between(text(), after), "Reset " + name);
}

PresetStore SceneBench::presets() const {
  require_document();
  return PresetStore(
      preset_folder.empty() ? std::filesystem::absolute(file()).parent_path() : preset_folder,
      file());
}

void SceneBench::save_preset(const std::string& name) {
  Preset preset{name, false, {}};
  for (const language::ParamSetting& each : params())
    preset.values.emplace_back(each.name, each.text);
  if (preset.values.empty())
    throw Error(ErrorCode::bad_input, "the text has no params that a preset could keep", {},
                "declare one, such as: param SIZE = 30cm in 1cm..3m");
  presets().save(preset);
}

void SceneBench::apply_preset(const std::string& name) {
  const Preset preset = presets().find(name);
  std::vector<language::TextEdit> edits;
  bool known = false;
  for (const auto& [param, value] : preset.values)
    for (const language::ParamSetting& each : params()) {
      if (each.name != param) continue;
      known = true;
      if (each.text != value) edits.push_back(language::set_param(*analysis(), param, value));
    }
  if (!known)
    throw Error(ErrorCode::bad_input,
                fmt::format("the text has none of the params of the preset '{}'", name), {},
                "save it again with the params of this text");
  const std::string after = language::apply(text(), std::move(edits));
  edit_recorded(change_between(text(), after), "Preset " + name);
}

}  // namespace vug::workbench
