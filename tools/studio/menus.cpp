// SPDX-License-Identifier: Apache-2.0
// Menus, keys and the tool bar of the window, from the table of commands.
#include "command_palette.h"
#include "keys.h"
#include "main_window.h"
#include "prompts.h"
#include "theme.h"

#include <vug/workbench/command.h>

#include <fmt/format.h>
#include <QApplication>
#include <QLabel>
#include <QMenuBar>
#include <QSlider>
#include <QToolBar>

namespace vug::studio {

QAction* MainWindow::add_command(QMenu* menu, const std::string& name, const QString& icon_name) {
  const workbench::Command& command = workbench::find_command(name);
  return add_command_of(menu, command, command.required > 0 || name == "save", icon_name);
}

QAction* MainWindow::add_action(QMenu* menu, const OwnAction& own) {
  QAction* action = add_entry(
      menu, {own.name, own.title, QKeySequence::listFromString(window_keys(own.name)), own.icon},
      own.run);
  action->setToolTip(own.doc);
  action->setStatusTip(own.doc);
  action->setData(own.needs_document);
  return own_[own.name] = action;
}

void MainWindow::build_menus() {
  menuBar()->setAccessibleName(tr("Menus"));
  QMenu* file = menuBar()->addMenu(tr("&File"));
  add_command(file, "photo", "photo");
  add_command(file, "open", "open");
  add_command(file, "save", "save");
  add_action(file, {"save as", tr("Save as..."), tr("Saves the session to another file."), [this] {
                      if (const std::string line = save_as_line(*this, studio_); !line.empty())
                        studio_.run(line);
                    }});
  add_command(file, "export", "export");
  file->addSeparator();
  add_command(file, "compare");
  add_command(file, "forget");
  file->addSeparator();
  add_action(file, {"quit", tr("Quit"), tr("Closes the window."), [this] { close(); }, "", false});
  build_edit_menu();
  build_facade_menu();
  build_view_menu();
}

void MainWindow::build_edit_menu() {
  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  add_command(edit, "undo", "undo");
  add_command(edit, "redo", "redo");
  edit->addSeparator();
  const auto selected = [this](const char* kind) {
    return [this, kind] {
      const workbench::FacadeBench& bench = studio_.bench();
      studio_.run(fmt::format("{} {}", kind, bench.state().path(bench.selected())));
    };
  };
  add_action(edit, {"retract", tr("Retract rule"), tr("Removes the rule of the selected part."),
                    selected("retract")});
  add_action(edit, {"separate", tr("Separate copies"),
                    tr("Makes mirrored or repeated parts independent."), selected("separate")});
  add_action(edit, {"join", tr("Join copies"),
                    tr("Makes separated parts copies of the first one again."), selected("join")});
  edit->addSeparator();
  add_command(edit, "checkpoint");
  add_command(edit, "restore");
}

void MainWindow::build_facade_menu() {
  QMenu* facade = menuBar()->addMenu(tr("F&acade"));
  add_action(facade,
             {"set scale", tr("Set scale..."), tr("Sets the scale by two clicks and a length."),
              [this] { canvas_->begin_scale(); }, "scale"});
  facade->addSeparator();
  for (int i = 0; i < 9; ++i)
    add_action(facade, {QString("act %1").arg(i + 1), tr("Action %1").arg(i + 1),
                        tr("Applies the action of this number to the selected part."),
                        [this, i] { actions_->perform(i); }});
  facade->addSeparator();
  add_action(facade, {"next open", tr("Select next open part"),
                      tr("Selects the next part that no rule divides."),
                      [this] { studio_.run("select open"); }});
  const auto cycle = [this](const char* line) {
    return [this, line] {
      studio_.run(line);
      canvas_->setFocus();
    };
  };
  add_action(facade, {"next handle", tr("Select next handle"),
                      tr("Selects the next line or edge of the selected part."), cycle("cycle")});
  add_action(facade,
             {"previous handle", tr("Select previous handle"),
              tr("Selects the previous line or edge of the selected part."), cycle("cycle -1")});
  facade->addSeparator();
  add_command(facade, "fit");
  add_command(facade, "stop");
}

void MainWindow::build_view_menu() {
  QMenu* view = menuBar()->addMenu(tr("&View"));
  add_action(view, {"frame", tr("Show whole facade"), tr("Shows the whole facade."),
                    [this] { canvas_->frame(); }, "frame"});
  const auto zoom = [this](double factor) {
    return [this, factor] {
      studio_.run(
          fmt::format("zoom {} {} {}", factor, canvas_->width() / 2, canvas_->height() / 2));
    };
  };
  add_action(view, {"zoom in", tr("Zoom in"), tr("Magnifies the view."), zoom(1.25)});
  add_action(view, {"zoom out", tr("Zoom out"), tr("Shrinks the view."), zoom(0.8)});
  add_command(view, "differences", "differences")->setCheckable(true);
  add_action(view, {"cancel", tr("Cancel"),
                    tr("Ends the drag, the setting of the scale, or the selection of a handle."),
                    [this] { canvas_->cancel(); }});
  view->addSeparator();
  for (const char* name : {"system", "light", "dark"})
    add_action(view, {QString("theme ") + name, tr("Theme: %1").arg(name),
                      tr("Sets the colours of the window."),
                      [this, name] {
                        set_theme(*qApp, name);
                        apply_theme();
                      },
                      "", false});
  view->addSeparator();
  add_action(view, {"palette", tr("Command palette..."), tr("Lists and runs all commands."),
                    [this] {
                      auto* palette = new CommandPalette(
                          palette_entries(workbench::all_commands(), studio_.bench()),
                          [this](const std::string& line) { return studio_.run(line); },
                          "act . RegularGrid columns=4", this);
                      palette->setAttribute(Qt::WA_DeleteOnClose);
                      palette->open();
                    },
                    "search", false});
}

void MainWindow::build_tool_bar() {
  QToolBar* bar = add_tools();
  for (const char* name : {"photo", "open", "save", "export"}) bar->addAction(command(name));
  bar->addSeparator();
  for (const char* name : {"undo", "redo"}) bar->addAction(command(name));
  bar->addSeparator();
  bar->addAction(own_.at("frame"));
  bar->addAction(own_.at("set scale"));
  bar->addAction(command("differences"));
  auto* space = new QWidget;
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  bar->addWidget(new QLabel(tr("Photo ")));
  opacity_ = new QSlider(Qt::Horizontal);
  opacity_->setObjectName("opacity");
  opacity_->setAccessibleName(tr("Opacity of the photo"));
  opacity_->setToolTip(tr("Opacity of the photo"));
  opacity_->setRange(0, 100);
  opacity_->setFixedWidth(110);
  connect(opacity_, &QSlider::valueChanged, this, [this](int value) {
    if (opacity_->isEnabled() && std::abs(value - 100 * studio_.bench().view().opacity) > 0.6)
      studio_.run(fmt::format("opacity {}", value / 100.0));
  });
  bar->addWidget(opacity_);
  bar->addAction(own_.at("palette"));
}

}  // namespace vug::studio
