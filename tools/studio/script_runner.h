// SPDX-License-Identifier: Apache-2.0
// Scripts: commands of the bench, events of the mouse and the keyboard, and assertions, one a line.
#pragma once

#include "heartbeat.h"
#include "main_window.h"

#include <filesystem>
#include <string>
#include <vector>

namespace vug::studio {

class ScriptRunner {
 public:
  ScriptRunner(Studio& studio, MainWindow& window, Heartbeat& heartbeat)
      : studio_(studio), window_(window), heartbeat_(heartbeat) {}

  /// Runs all lines. Error(bad_input) with the file and the line for the first line that fails.
  void run(const std::filesystem::path& file);
  void run_line(const std::string& line);

 private:
  void expect(const std::vector<std::string>& words);
  void grab(const std::vector<std::string>& words);
  void wait(const std::vector<std::string>& words);

  Studio& studio_;
  MainWindow& window_;
  Heartbeat& heartbeat_;
};

/// Sends the events of one line to the widgets: click, double-click, drag, key, type, hover, wheel.
/// False for another line. Error(bad_input) for a widget that does not exist.
bool send_events(Studio& studio, MainWindow& window, const std::vector<std::string>& words);

/// The visible widget or the action of that name. Error(bad_input) if it does not exist.
QWidget& find_widget(const std::string& name);

/// Names, tab order and keys of all widgets: one line for each fault; empty if there is none.
QString audit(MainWindow& window);

}  // namespace vug::studio
