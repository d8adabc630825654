// SPDX-License-Identifier: Apache-2.0
// The controller of the window: it owns the facade bench and runs all commands.
#pragma once

#include <vug/workbench/facade_bench.h>
#include <vug/workbench/recovery.h>

#include <QObject>
#include <QString>
#include <atomic>

namespace vug::studio {

class Studio : public QObject {
  Q_OBJECT
 public:
  explicit Studio(QObject* parent = nullptr);

  workbench::FacadeBench& bench() { return bench_; }
  const workbench::FacadeBench& bench() const { return bench_; }
  workbench::Recorder& recorder() { return recorder_; }

  /// Runs a command line; throws vug::Error.
  void execute(const std::string& line);
  /// Runs a command line and shows its error as a message; false if it failed.
  bool run(const std::string& line);
  /// The line of an edit, for `run`.
  bool run(const modeller::Edit& edit);
  /// Recovers the work of a killed program. An error is shown as a message; false if it prevented
  /// that the document was opened.
  bool recover(const workbench::LostJournal& lost);
  void end_preview();
  void select(int node);
  /// The action whose result is shown as ghost lines; -1 for none.
  int hovered_action() const { return hovered_action_; }
  void hover_action(int index);
  /// Takes the news of the threads of the bench.
  void poll();

 Q_SIGNALS:
  void changed();   ///< Document, selection, view or score.
  void opened();    ///< Another document.
  void hovered();   ///< Another action is hovered.
  void restyled();  ///< Another theme.
  void message(const QString& text, bool error);

 private:
  void show(const Error& error);

  std::atomic<bool> pending_{false};
  int hovered_action_ = -1;
  workbench::FacadeBench bench_;
  workbench::Recorder recorder_;
};

/// Text of the library, which is UTF-8.
inline QString text_of(const std::string& text) { return QString::fromStdString(text); }

}  // namespace vug::studio
