// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/base/error.h>
#include <vug/picture/picture_plan.h>
#include <vug/picture/render_choice.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace vug::picture {
namespace {

using Names = std::vector<std::string>;

/// "plan (camera 'top', 800x600)".
std::string describe_render(const shot::Shot& shot, const shot::RenderPlan& plan) {
  const std::string camera = camera_name(shot, plan);
  return fmt::format("{} ({}, {})", plan.name,
                     camera.empty() ? "outside view" : fmt::format("camera '{}'", camera),
                     fmt::join(plan.settings.size, "x"));
}

/// The blocks of the scene's own text, or else those of included files.
std::vector<const shot::RenderPlan*> own_renders(const shot::Shot& shot) {
  std::vector<const shot::RenderPlan*> own, all;
  for (const shot::RenderPlan& plan : shot.renders) {
    all.push_back(&plan);
    if (!plan.included) own.push_back(&plan);
  }
  return own.empty() ? all : own;
}

Error none_chosen(const shot::Shot& shot) {
  Names blocks;
  for (const shot::RenderPlan* plan : own_renders(shot))
    blocks.push_back(describe_render(shot, *plan));
  return Error(ErrorCode::bad_input,
               fmt::format("the scene has {} renders, and none is chosen", blocks.size()), {},
               fmt::format("write --render NAME or --render {}; its renders: {}", kAllRenders,
                           fmt::join(blocks, ", ")));
}

}  // namespace

Names choose_renders(const shot::Shot& shot, const Names& wanted) {
  Names known, own, chosen;
  for (const shot::RenderPlan& plan : shot.renders) known.push_back(plan.name);
  for (const shot::RenderPlan* plan : own_renders(shot)) own.push_back(plan->name);
  if (wanted.empty() && own.size() > 1) throw none_chosen(shot);
  const auto add = [&](const std::string& name) {
    if (std::find(chosen.begin(), chosen.end(), name) == chosen.end()) chosen.push_back(name);
  };
  for (const std::string& name : wanted.empty() ? Names{kAllRenders} : wanted) {
    const bool is_known = std::find(known.begin(), known.end(), name) != known.end();
    if (is_known)
      add(name);
    else if (name == kAllRenders)
      std::for_each(own.begin(), own.end(), add);
    else
      throw Error(ErrorCode::bad_input, fmt::format("the scene has no render '{}'", name), {},
                  suggestion(name, known));
  }
  return chosen.empty() ? Names{""} : chosen;
}

std::filesystem::path path_of_render(const std::filesystem::path& path, const std::string& render) {
  std::string name = path.stem().string();
  // The frame number, such as ".####" or "_%04d", ends the name.
  size_t at = name.find_last_not_of('#') + 1;
  if (at == name.size() && name.ends_with('d')) {
    const size_t percent = name.rfind('%');
    if (percent != std::string::npos &&
        name.find_first_not_of("0123456789", percent + 1) == name.size() - 1)
      at = percent;
  }
  if (at < name.size() && at > 0 && std::string("._-").find(name[at - 1]) != std::string::npos)
    --at;
  name.insert(at, at > 0 ? "_" + render : render + "_");
  return path.parent_path() / (name + path.extension().string());
}

}  // namespace vug::picture
