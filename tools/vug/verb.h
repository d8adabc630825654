// A verb of the command: `vug VERB ...`. One file each in verbs/, listed in CMakeLists.txt.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <functional>
#include <string>

namespace vug::cli {

/// What scripts may rely on.
enum Exit : int {
  kDone = 0,      ///< The work is done.
  kAnswerNo = 1,  ///< The answer is no: a broken mesh, a difference.
  kUnusable = 2,  ///< Input or arguments cannot be used.
  kFailed = 3,    ///< Something failed while working.
};

struct Verb {
  std::string name;
  std::string doc;
  /// Adds the options to the subcommand and gives what runs it; that returns an Exit.
  std::function<std::function<int()>(CLI::App&)> setup;
};

/// Thrown by a verb that has said what is wrong already.
struct ExitRequest {
  int exit;
};

}  // namespace vug::cli
