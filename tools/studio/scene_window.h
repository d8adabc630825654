// SPDX-License-Identifier: Apache-2.0
// The window of a scene: editor at the left, picture at the right, parameters and outline next to
// it, problems at the bottom.
#pragma once

#include "scene_editor.h"
#include "scene_studio.h"
#include "viewport_widget.h"

#include <QMainWindow>
#include <functional>
#include <map>
#include <string>
#include <vector>

class QComboBox;
class QLabel;

namespace vug::studio {

class SceneWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit SceneWindow(SceneStudio& studio);

  SceneEditor& editor() { return *editor_; }
  ViewportWidget& viewport() { return *viewport_; }
  QString shown_message() const;
  /// Offers the journals of killed programs.
  void offer_recovery(const std::vector<workbench::LostJournal>& lost);
  /// Draws everything again with the colours of the theme.
  void apply_theme();

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void build_panels();
  void build_menus();
  QAction* add_command(class QMenu* menu, const std::string& name, const QString& icon = "");
  void add_action(class QMenu* menu, const QString& name, const QString& title,
                  const std::function<void()>& run, const QString& icon = "");
  void refresh();
  void show_status();
  void show_message(const QString& text, bool error);
  void ask_and_run(const std::string& name);
  bool may_discard();

  SceneStudio& studio_;
  SceneEditor* editor_ = nullptr;
  ViewportWidget* viewport_ = nullptr;
  QComboBox* mode_ = nullptr;
  QLabel *message_ = nullptr, *status_ = nullptr;
  QWidget* recovery_ = nullptr;
  std::map<std::string, QAction*> commands_;
  std::map<QAction*, QString> icons_;
};

}  // namespace vug::studio
