// SPDX-License-Identifier: Apache-2.0
// The controller of the window: it owns the facade bench and runs all commands.
#pragma once

#include "bench_studio.h"

#include <vug/workbench/facade_bench.h>

#include <atomic>

namespace vug::studio {

class Studio : public BenchStudio {
  Q_OBJECT
 public:
  explicit Studio(QObject* parent = nullptr);

  workbench::FacadeBench& bench() { return bench_; }
  const workbench::FacadeBench& bench() const { return bench_; }
  workbench::Recorder& recorder() { return recorder_; }

  void execute(const std::string& line) override;
  using BenchStudio::run;
  /// The line of an edit, for `run`.
  bool run(const modeller::Edit& edit);
  bool recover(const workbench::LostJournal& lost) override;
  void end_preview();
  void select(int node);
  /// The action whose result is shown as ghost lines; -1 for none.
  int hovered_action() const { return hovered_action_; }
  void hover_action(int index);
  /// Takes the news of the threads of the bench.
  void poll();

 Q_SIGNALS:
  void opened();   ///< Another document.
  void hovered();  ///< Another action is hovered.

 private:
  std::atomic<bool> pending_{false};
  int hovered_action_ = -1;
  workbench::FacadeBench bench_;
  workbench::Recorder recorder_;
};

}  // namespace vug::studio
