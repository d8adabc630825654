// SPDX-License-Identifier: Apache-2.0
// The controller of the window of scenes: it owns the scene bench, runs all commands, and decides
// when the text is built.
#pragma once

#include "bench_studio.h"
#include "render_runner.h"

#include <vug/workbench/scene_bench.h>

#include <QElapsedTimer>
#include <QFileSystemWatcher>
#include <QTimer>
#include <atomic>

namespace vug::studio {

class SceneStudio : public BenchStudio {
  Q_OBJECT
 public:
  explicit SceneStudio(QObject* parent = nullptr);

  workbench::SceneBench& bench() { return bench_; }
  const workbench::SceneBench& bench() const { return bench_; }
  workbench::SceneRecorder& recorder() { return recorder_; }

  RenderRunner& runner() { return runner_; }

  void execute(const std::string& line) override;
  bool recover(const workbench::LostJournal& lost) override;
  /// The user moved the caret to another line.
  void set_caret(int line);
  /// Takes the news of the viewport.
  void poll();
  /// Whether a thread works, or a change waits for the end of the typing.
  bool busy() const { return bench_.busy(); }

 Q_SIGNALS:
  void analysed();  ///< The meaning of the words, the outline and the parameters.
  void news();      ///< The status of the viewport.
  /// Another program has changed these lines of the file; empty: none.
  void file_changed(const QString& lines);

 private:
  /// Watches the file of the document, and compares it with the text that was opened or saved.
  void check_file();
  /// Builds a changed text, at once or after a rest of the typing.
  void schedule(bool typing, bool drag);
  /// Whether the build of an earlier step of a drag may soon end.
  bool shows_soon() const;
  void build();

  std::atomic<bool> pending_{false};
  workbench::SceneBench bench_;
  workbench::SceneRecorder recorder_;
  workbench::RenderQueue queue_;
  RenderRunner runner_;
  QTimer typed_;  ///< Ends when the user stops typing.
  QTimer rest_;   ///< Ends when the undo step of the typing is complete.
  QFileSystemWatcher watcher_;
  QTimer touched_;  ///< Ends when a program that writes the file should have finished.
  QElapsedTimer since_build_;
  bool waits_ = false;  ///< A change waits for the end of a build.
  uint64_t known_ = 0;  ///< The revision that was announced.
};

}  // namespace vug::studio
