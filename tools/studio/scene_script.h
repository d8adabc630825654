// SPDX-License-Identifier: Apache-2.0
// Scripts of the window of scenes.
#pragma once

#include "scene_window.h"
#include "script_host.h"

namespace vug::studio {

class SceneScript : public ScriptHost {
 public:
  SceneScript(SceneStudio& studio, SceneWindow& window) : studio_(studio), window_(window) {}

  QWidget& window() override { return window_; }
  void execute(const std::string& line) override { studio_.execute(line); }
  void expect(const std::vector<std::string>& words) override;
  bool busy() override { return studio_.busy(); }
  void poll() override { studio_.poll(); }
  std::string message() override { return window_.shown_message().toStdString(); }
  void restyle() override { window_.apply_theme(); }
  bool send_event(const std::vector<std::string>& words) override;

 private:
  void wait_for_renders();

  SceneStudio& studio_;
  SceneWindow& window_;
};

}  // namespace vug::studio
