// SPDX-License-Identifier: Apache-2.0
#include <vug/scout/shot_text.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace vug::scout {

std::vector<std::string> lamp_names(const std::vector<Lamp>& lamps) {
  std::vector<std::string> names;
  std::map<LampRole, int> known;
  for (const Lamp& lamp : lamps) {
    const int before = known[lamp.role]++;
    names.push_back(role_name(lamp.role) + (before == 0 ? "" : std::to_string(before + 1)));
  }
  return names;
}

std::string lamps_text(const std::vector<Lamp>& lamps, const std::string& prefix,
                       const std::string& module) {
  if (lamps.empty()) return "";
  std::string text = fmt::format("include \"kit/lamps.vug\" as {}\n", module);
  const std::vector<std::string> names = lamp_names(lamps);
  size_t width = 0;  // as vug format aligns them
  for (const std::string& name : names) width = std::max(width, name.size());
  for (size_t i = 0; i < lamps.size(); ++i)
    text +=
        fmt::format("light {}{:<{}} = {}\n", prefix, names[i], width, lamp_call(lamps[i], module));
  return text;
}

std::string shot_text(const ScoutedShot& shot, size_t number, const std::string& scene) {
  const Pose& pose = shot.candidate.pose;
  const ScoreTerms& t = shot.terms;
  std::string text = fmt::format("# Shot {} of {}. Use it with: camera main {{ scout {} }}\n",
                                 number, scene, number);
  text += fmt::format(
      "# score {:.2f}: depth {:.2f}, layers {:.2f}, lead {:.2f}, lines {:.2f}, frame {:.2f}, "
      "landmarks {:.2f}, sizes {:.2f}\n",
      shot.score, t.depth, t.layers, t.lead, t.lines, t.frame, t.landmarks, t.sizes);
  text += fmt::format("camera shot{} {{ eye {}  target {}  fov {:.4g}deg }}\n", number,
                      point_text(pose.eye), point_text(target_of(pose)), pose.fov / kDegree);
  return text + lamps_text(shot.lamps, fmt::format("shot{}_", number),
                           fmt::format("shot{}_lamps", number));
}

}  // namespace vug::scout
