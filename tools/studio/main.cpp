// SPDX-License-Identifier: Apache-2.0
// vug-studio: the desktop program.
#include "facade_script.h"
#include "heartbeat.h"
#include "keys.h"
#include "scene_script.h"
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
  QCommandLineOption keys{"keys", "Print the table of keys and exit; with --scene, of scenes."};
  QCommandLineOption scene{"scene", "Open the window of scenes, also without a file."};

  ProgramOptions() {
    parser.setApplicationDescription(
        "Edits scenes next to their picture, and models facades over photos.");
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(
        "file",
        "Scene with the extension .vug, photo of a facade, or session with the extension .json.");
    parser.addOptions({script, heartbeat, colours, keys, scene});
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

/// The journals of killed windows of this kind.
std::vector<workbench::LostJournal> journals(const std::filesystem::path& folder, bool scenes) {
  std::vector<workbench::LostJournal> lost = workbench::lost_journals(folder);
  std::erase_if(lost,
                [&](const auto& each) { return workbench::is_scene_journal(each) != scenes; });
  return lost;
}

/// Runs the program with one of the windows.
template <class Controller, class Window, class Script>
int run_window(QApplication& app, const ProgramOptions& arguments, const std::string& first_line,
               bool scenes) {
  Controller studio;
  Window window(studio);
  studio::Heartbeat heartbeat(10);
  window.show();
  if (!first_line.empty()) studio.run(first_line);
  window.offer_recovery(journals(studio.recorder().folder(), scenes));
  int code = kDone;
  if (arguments.parser.isSet(arguments.script)) {
    QTimer::singleShot(0, &app, [&] {
      Script host(studio, window);
      studio::ScriptRunner runner(host, heartbeat);
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

}  // namespace

int main(int argc, char** argv) {
  QApplication app(argc, argv);
  QApplication::setApplicationName("vug-studio");
  QApplication::setApplicationVersion(VUG_VERSION);
  ProgramOptions arguments;
  arguments.parser.process(app);
  if (arguments.parser.isSet(arguments.keys)) {
    const bool scene = arguments.parser.isSet(arguments.scene);
    fmt::print("{}", scene ? studio::scene_key_table() : studio::key_table());
    return kDone;
  }
  studio::set_theme(app, arguments.parser.value(arguments.colours));
  const QString file = arguments.parser.positionalArguments().value(0);
  const std::string name = workbench::quoted(file.toStdString());
  if (file.endsWith(".vug") || arguments.parser.isSet(arguments.scene))
    return run_window<studio::SceneStudio, studio::SceneWindow, studio::SceneScript>(
        app, arguments, file.isEmpty() ? "" : "open " + name, true);
  const std::string line =
      file.isEmpty() ? "" : (file.endsWith(".json") ? "open " : "photo ") + name;
  return run_window<studio::Studio, studio::MainWindow, studio::FacadeScript>(app, arguments, line,
                                                                              false);
}
