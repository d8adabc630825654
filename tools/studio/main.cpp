// SPDX-License-Identifier: Apache-2.0
// vug-studio: the desktop program.
#include "heartbeat.h"
#include "keys.h"
#include "main_window.h"
#include "script_runner.h"
#include "theme.h"

#include <vug/workbench/words.h>

#include <fmt/format.h>
#include <QApplication>
#include <QCommandLineParser>
#include <QTimer>
#include <cstdio>

namespace {

using namespace vug;

constexpr int kDone = 0, kUnusable = 2, kFailed = 3;

int print_error(const Error& error) {
  fmt::print(stderr, "error: {}\n", error.located_message());
  if (!error.hint().empty()) fmt::print(stderr, "hint: {}\n", error.hint());
  return error.code() == ErrorCode::bad_input || error.code() == ErrorCode::too_large ? kUnusable
                                                                                      : kFailed;
}

struct ProgramOptions {
  QCommandLineParser parser;
  QCommandLineOption script{"script", "Run a script of commands without a user, then exit.",
                            "file"};
  QCommandLineOption heartbeat{"heartbeat", "Print the longest delay of the event loop."};
  QCommandLineOption colours{"theme", "Colours: system, light or dark.", "name", "system"};
  QCommandLineOption keys{"keys", "Print the table of keys and exit."};

  ProgramOptions() {
    parser.setApplicationDescription("Models facades over photos with the rules of a grammar.");
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument("file", "Photo, or session with the extension .json.");
    parser.addOptions({script, heartbeat, colours, keys});
  }
};

int run_script(studio::ScriptRunner& runner, const std::string& file) {
  try {
    runner.run(file);
    return kDone;
  } catch (const Error& error) {
    return print_error(error);
  }
}

}  // namespace

int main(int argc, char** argv) {
  QApplication app(argc, argv);
  QApplication::setApplicationName("vug-studio");
  QApplication::setApplicationVersion(VUG_VERSION);
  ProgramOptions arguments;
  arguments.parser.process(app);
  if (arguments.parser.isSet(arguments.keys)) {
    fmt::print("{}", studio::key_table());
    return kDone;
  }
  studio::set_theme(app, arguments.parser.value(arguments.colours));
  studio::Studio studio;
  studio::MainWindow window(studio);
  studio::Heartbeat heartbeat(10);
  window.show();
  const QStringList files = arguments.parser.positionalArguments();
  if (!files.isEmpty()) {
    const bool session = files[0].endsWith(".json");
    studio.run((session ? "open " : "photo ") + workbench::quoted(files[0].toStdString()));
  }
  window.offer_recovery(workbench::lost_journals(studio.recorder().folder()));
  int code = kDone;
  if (arguments.parser.isSet(arguments.script)) {
    QTimer::singleShot(0, &app, [&] {
      studio::ScriptRunner runner(studio, window, heartbeat);
      code = run_script(runner, arguments.parser.value(arguments.script).toStdString());
      QApplication::exit(code);
    });
  }
  code = std::max(code, QApplication::exec());
  if (arguments.parser.isSet(arguments.heartbeat))
    fmt::print(stderr, "longest delay of the event loop: {} ms; longest computation: {} ms\n",
               heartbeat.worst_delay(), heartbeat.worst_work());
  return code;
}
