// SPDX-License-Identifier: Apache-2.0
// What the windows of all benches have: commands in menus, a line of messages, the recovery of
// lost work, themes, and the question about unsaved work.
#pragma once

#include "bench_studio.h"

#include <vug/workbench/recovery.h>

#include <QKeySequence>
#include <QMainWindow>
#include <functional>
#include <map>
#include <string>
#include <vector>

class QLabel;

namespace vug::studio {

class BenchWindow : public QMainWindow {
  Q_OBJECT
 public:
  QString shown_message() const;
  /// Offers the journals of killed programs.
  void offer_recovery(const std::vector<workbench::LostJournal>& lost);
  /// Draws everything again with the colours of the theme.
  void apply_theme();

 protected:
  explicit BenchWindow(BenchStudio& studio);

  void closeEvent(QCloseEvent* event) override;
  /// Asks about unsaved work; whether the document may be closed.
  virtual bool may_discard() = 0;
  /// Asks for what a command needs, and runs it.
  virtual void ask_and_run(const std::string& name) = 0;

  /// Shows the content, with room for the offer of lost work above it.
  void set_content(QWidget* content);
  /// Adds the line of messages, and a part of the status bar that is always visible.
  void build_status_bar(QWidget* permanent);

  /// An entry of a menu.
  struct Entry {
    QString name, title;
    QList<QKeySequence> keys = {};
    QString icon = {};
  };
  QAction* add_entry(QMenu* menu, const Entry& entry, const std::function<void()>& run);
  /// An entry that runs a command of the table, or asks first.
  template <class Command>
  QAction* add_command_of(QMenu* menu, const Command& command, bool asks, const QString& icon) {
    const std::string name = command.name;
    return commands_[name] =
               add_entry(menu,
                         {text_of(name), text_of(command.title),
                          QKeySequence::listFromString(text_of(command.keys)), icon},
                         [this, name, asks] { asks ? ask_and_run(name) : void(base_.run(name)); });
  }
  /// Greys commands that are not available, with the reason. `find` is the table of commands.
  template <class Bench, class Find>
  void refresh_commands(const Bench& bench, const Find& find) {
    for (const auto& [name, action] : commands_) {
      const auto& command = find(name);
      show_availability(*action, text_of(command.doc),
                        command.unavailable ? command.unavailable(bench) : "");
    }
  }
  /// Names the steps that undo and redo concern; empty: none.
  void name_steps(const std::string& undo, const std::string& redo);
  void set_title(const std::string& file, bool modified);

  QAction* command(const std::string& name) const { return commands_.at(name); }
  /// The tool bar, without buttons.
  class QToolBar* add_tools();

 private:
  static void show_availability(QAction& action, const QString& doc, const std::string& obstacle);
  void show_message(const QString& text, bool error);

  BenchStudio& base_;
  QLabel* message_ = nullptr;
  QWidget* recovery_ = nullptr;
  std::map<std::string, QAction*> commands_;
  std::map<QAction*, QString> icons_;
};

}  // namespace vug::studio
