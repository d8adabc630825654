// SPDX-License-Identifier: Apache-2.0
// The controller of the window of scenes: it owns the scene bench, runs all commands, and decides
// when the text is built.
#pragma once

#include <vug/workbench/recovery.h>
#include <vug/workbench/scene_bench.h>

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>
#include <atomic>

namespace vug::studio {

class SceneStudio : public QObject {
  Q_OBJECT
 public:
  explicit SceneStudio(QObject* parent = nullptr);

  workbench::SceneBench& bench() { return bench_; }
  const workbench::SceneBench& bench() const { return bench_; }
  workbench::SceneRecorder& recorder() { return recorder_; }

  /// Runs a command line; throws vug::Error.
  void execute(const std::string& line);
  /// Runs a command line and shows its error as a message; false if it failed.
  bool run(const std::string& line);
  /// Recovers the work of a killed program. An error is shown as a message; false if it prevented
  /// that the document was opened.
  bool recover(const workbench::LostJournal& lost);
  /// Takes the news of the viewport.
  void poll();
  /// Whether a thread works, or a change waits for the end of the typing.
  bool busy() const { return bench_.busy(); }

 Q_SIGNALS:
  void changed();   ///< The text or the selection.
  void analysed();  ///< The meaning of the words, the outline and the parameters.
  void news();      ///< The status of the viewport.
  void restyled();  ///< Another theme.
  void message(const QString& text, bool error);

 private:
  void show(const Error& error);
  /// Builds a changed text, at once or after a rest of the typing.
  void schedule(bool typing, bool drag);
  /// Whether the build of an earlier step of a drag may soon end.
  bool shows_soon() const;
  void build();

  std::atomic<bool> pending_{false};
  workbench::SceneBench bench_;
  workbench::SceneRecorder recorder_;
  QTimer typed_;  ///< Ends when the user stops typing.
  QTimer rest_;   ///< Ends when the undo step of the typing is complete.
  QElapsedTimer since_build_;
  bool waits_ = false;  ///< A change waits for the end of a build.
  uint64_t known_ = 0;  ///< The revision that was announced.
};

}  // namespace vug::studio
