// SPDX-License-Identifier: Apache-2.0
// Menus, keys and the tool bar of the window of scenes, from the table of commands.
#include "command_palette.h"
#include "keys.h"
#include "scene_window.h"
#include "theme.h"

#include <vug/workbench/scene_command.h>

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QMenuBar>
#include <QToolBar>

namespace vug::studio {

QAction* SceneWindow::add_command(QMenu* menu, const std::string& name, const QString& icon_name) {
  const workbench::SceneCommand& command = workbench::find_scene_command(name);
  return add_command_of(menu, command, command.required > 0, icon_name);
}

void SceneWindow::add_action(QMenu* menu, const QString& name, const QString& title,
                             const std::function<void()>& run, const QString& icon_name) {
  add_entry(menu, {name, title, QKeySequence::listFromString(scene_keys(name)), icon_name}, run);
}

void SceneWindow::build_menus() {
  menuBar()->setAccessibleName(tr("Menus"));
  QMenu* file = menuBar()->addMenu(tr("&File"));
  add_command(file, "open", "open");
  add_command(file, "save", "save");
  add_command(file, "reload");
  add_action(file, "save as", tr("Save as..."), [this] { ask_and_run("save"); });
  file->addSeparator();
  add_command(file, "queue_render");
  file->addSeparator();
  add_action(file, "quit", tr("Quit"), [this] { close(); });

  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  add_command(edit, "undo", "undo");
  add_command(edit, "redo", "redo");
  edit->addSeparator();
  add_action(edit, "complete", tr("Complete"), [this] { editor_->complete(); });
  add_command(edit, "go");
  add_command(edit, "write_view");
  add_command(edit, "save_preset");

  QMenu* view = menuBar()->addMenu(tr("&View"));
  add_command(view, "home");
  add_command(view, "frame", "frame");
  add_command(view, "refresh");
  add_command(view, "stop");
  add_command(view, "region");
  add_command(view, "pause");
  add_command(view, "continue");
  add_command(view, "denoise");
  add_command(view, "go_material");
  add_command(view, "gizmos");
  add_command(view, "keep_picture");
  add_command(view, "compare");
  view->addSeparator();
  for (const auto& [name, widget] :
       {std::pair<QString, QWidget*>("edit text", editor_), {"look at picture", viewport_}})
    add_action(view, name, name == "edit text" ? tr("Go to the text") : tr("Go to the picture"),
               [widget = widget] { widget->setFocus(); });
  add_action(view, "list problems", tr("List the problems"), [this] { show_list(0); });
  add_action(view, "list pictures", tr("List the kept pictures"), [this] { show_list(1); });
  add_action(view, "list renders", tr("List the renders"), [this] { show_list(2); });
  view->addSeparator();
  for (const char* name : {"system", "light", "dark"})
    add_action(view, QString("theme ") + name, tr("Theme: %1").arg(name), [this, name] {
      set_theme(*qApp, name);
      apply_theme();
    });
  view->addSeparator();
  add_action(
      view, "palette", tr("Command palette..."),
      [this] {
        auto* palette = new CommandPalette(
            palette_entries(workbench::scene_commands(), studio_.bench()),
            [this](const std::string& line) { return studio_.run(line); }, "mode path", this);
        palette->setAttribute(Qt::WA_DeleteOnClose);
        palette->open();
      },
      "search");

  QToolBar* bar = add_tools();
  for (const char* name : {"open", "save"}) bar->addAction(command(name));
  bar->addSeparator();
  for (const char* name : {"undo", "redo"}) bar->addAction(command(name));
  bar->addSeparator();
  bar->addAction(command("frame"));
  auto* space = new QWidget;
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  bar->addWidget(new QLabel(tr("Display ")));
  mode_ = new QComboBox;
  mode_->setObjectName("mode");
  mode_->setAccessibleName(tr("Display"));
  for (const std::string& name : viewport::mode_names()) mode_->addItem(text_of(name));
  connect(mode_, &QComboBox::activated, this,
          [this](int index) { studio_.run("mode " + mode_->itemText(index).toStdString()); });
  bar->addWidget(mode_);
}

}  // namespace vug::studio
