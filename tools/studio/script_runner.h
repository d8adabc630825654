// SPDX-License-Identifier: Apache-2.0
// Scripts: commands of the bench, events of the mouse and the keyboard, and assertions, one a line.
#pragma once

#include "heartbeat.h"
#include "script_host.h"

#include <QString>
#include <filesystem>
#include <string>
#include <vector>

namespace vug::studio {

class ScriptRunner {
 public:
  ScriptRunner(ScriptHost& host, Heartbeat& heartbeat) : host_(host), heartbeat_(heartbeat) {}

  /// Runs all lines. Error(bad_input) with the file and the line for the first line that fails.
  void run(const std::filesystem::path& file);
  void run_line(const std::string& line);

 private:
  void expect(const std::vector<std::string>& words);
  void grab(const std::vector<std::string>& words);
  void wait(const std::vector<std::string>& words);

  ScriptHost& host_;
  Heartbeat& heartbeat_;
};

/// Sends the events of one line to the widgets: click, double-click, key, type, hover, focus,
/// slide. False for another line. Error(bad_input) for a widget that does not exist.
bool send_events(QWidget& window, const std::vector<std::string>& words);
/// Error(bad_input) with the usage unless there are at least this many words.
void require_words(const std::vector<std::string>& words, size_t least, const char* usage);

/// The visible widget or the action of that name. Error(bad_input) if it does not exist.
QWidget& find_widget(const std::string& name);

/// Names, tab order and keys of all widgets: one line for each fault; empty if there is none.
QString audit(QWidget& window);

}  // namespace vug::studio
