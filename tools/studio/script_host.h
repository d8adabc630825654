// SPDX-License-Identifier: Apache-2.0
// What a script needs of a window: the one of facades or the one of scenes.
#pragma once

#include <string>
#include <vector>

class QWidget;

namespace vug::studio {

class ScriptHost {
 public:
  virtual ~ScriptHost() = default;
  virtual QWidget& window() = 0;
  /// Runs a command; throws vug::Error.
  virtual void execute(const std::string& line) = 0;
  /// Evaluates an assertion about the bench or the window; throws vug::Error.
  virtual void expect(const std::vector<std::string>& words) = 0;
  virtual bool busy() = 0;  ///< Whether a thread works, or its result has not been taken.
  virtual void poll() = 0;  ///< Takes the results of threads.
  virtual std::string message() = 0;
  virtual void restyle() = 0;  ///< Draws the window again with the colours of the theme.
  /// Sends the events of a line that only this window has; false for another line.
  virtual bool send_event(const std::vector<std::string>& words) = 0;
};

}  // namespace vug::studio
