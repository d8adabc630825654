// SPDX-License-Identifier: Apache-2.0
// The window of the facade bench, laid out like figure 3 of ripperda2009: actions upper left, the
// derivation tree lower left, the canvas in the middle, the specification at the bottom.
#pragma once

#include "action_panel.h"
#include "bench_window.h"
#include "canvas.h"
#include "studio.h"

class QSlider;

namespace vug::studio {

class MainWindow : public BenchWindow {
  Q_OBJECT
 public:
  explicit MainWindow(Studio& studio);

  Canvas& canvas() { return *canvas_; }
  ActionPanel& actions() { return *actions_; }

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QAction* add_command(class QMenu* menu, const std::string& name, const QString& icon = "");
  /// An action of the window itself, which has no command.
  struct OwnAction {
    QString name, title, doc;
    std::function<void()> run;
    QString icon = {};
    bool needs_document = true;
  };
  QAction* add_action(QMenu* menu, const OwnAction& own);
  void build_menus();
  void build_edit_menu();
  void build_facade_menu();
  void build_view_menu();
  void build_tool_bar();
  void build_panels();
  void refresh();
  void ask_and_run(const std::string& name) override;
  bool may_discard() override;

  Studio& studio_;
  Canvas* canvas_ = nullptr;
  ActionPanel* actions_ = nullptr;
  QSlider* opacity_ = nullptr;
  std::map<QString, QAction*> own_;  ///< Actions of the window itself, by name.
};

}  // namespace vug::studio
