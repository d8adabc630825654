// SPDX-License-Identifier: Apache-2.0
// A verb of the command, `vug VERB ...`. Each verb is a file in verbs/ and a line in
// CMakeLists.txt.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <functional>
#include <string>

namespace vug::cli {

/// Exit codes, which scripts may rely on.
enum Exit : int {
  kDone = 0,      ///< The work is done.
  kAnswerNo = 1,  ///< The answer is no, e.g. a broken mesh or a difference.
  kUnusable = 2,  ///< The input or the arguments cannot be used.
  kFailed = 3,    ///< An operation failed.
};

struct Verb {
  std::string name;
  std::string doc;
  /// Adds the options to the subcommand and returns the function that runs it, which returns an
  /// Exit.
  std::function<std::function<int()>(CLI::App&)> setup;
};

/// Thrown by a verb that has already reported its error.
struct ExitRequest {
  int exit;
};

}  // namespace vug::cli
