// SPDX-License-Identifier: Apache-2.0
// The window of a scene: editor at the left, picture at the right, parameters and outline next to
// it, problems at the bottom.
#pragma once

#include "bench_window.h"
#include "scene_editor.h"
#include "scene_studio.h"
#include "viewport_widget.h"

class QComboBox;
class QLabel;
class QTabWidget;

namespace vug::studio {

class SceneWindow : public BenchWindow {
  Q_OBJECT
 public:
  explicit SceneWindow(SceneStudio& studio);

  SceneEditor& editor() { return *editor_; }
  ViewportWidget& viewport() { return *viewport_; }

 private:
  void build_panels();
  void show_list(int index);
  void ask_for_render();
  void build_menus();
  QAction* add_command(class QMenu* menu, const std::string& name, const QString& icon = "");
  void add_action(class QMenu* menu, const QString& name, const QString& title,
                  const std::function<void()>& run, const QString& icon = "");
  void refresh();
  void show_status();
  void ask_and_run(const std::string& name) override;
  bool may_discard() override;

  SceneStudio& studio_;
  SceneEditor* editor_ = nullptr;
  ViewportWidget* viewport_ = nullptr;
  QTabWidget* lists_ = nullptr;  ///< Problems, kept pictures and so on.
  QComboBox* mode_ = nullptr;
  QLabel* status_ = nullptr;
};

}  // namespace vug::studio
