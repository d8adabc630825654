// SPDX-License-Identifier: Apache-2.0
// Progress on stderr, and cancellation by signals.
#pragma once

#include "stage_times.h"

#include <vug/base/progress.h>

#include <string>

namespace vug::cli {

/// How stages are reported: as bars, as one line each when they end, or not at all.
enum class ProgressBarMode { on_terminals, always, never };

/// The Progress of the process, which reports the stages of the work on stderr. `on_terminals`:
/// bars with the remaining time if stderr is a terminal; otherwise a line with the time of each
/// stage that takes a tenth of a second or more, for logs. Call it once.
Progress& terminal_progress(ProgressBarMode shown);

/// Reports a stage outside of a Progress, such as loading: 0 begins it, 1 ends it.
void report_stage(ProgressBarMode shown, const std::string& stage, double fraction);

/// Runs work without a Progress as a stage, and returns its result.
template <class Work>
auto show_stage(ProgressBarMode shown, const std::string& stage, const Work& work) {
  report_stage(shown, stage, 0);
  auto result = work();
  report_stage(shown, stage, 1);
  return result;
}

/// The times of all stages so far, shown or not.
const StageTimes& stage_times();

/// Makes Ctrl-C (SIGINT) and SIGTERM cancel the Progress of the process. Before one exists they end
/// the process with a message. A second signal kills the process.
void install_signal_handlers();

/// Ends the line of a visible bar. Call it before other output.
void clear_progress_bar();

}  // namespace vug::cli
