// SPDX-License-Identifier: Apache-2.0
// Progress bar on a terminal, and cancellation by signals.
#pragma once

#include <vug/base/progress.h>

namespace vug::cli {

/// When the progress bar is drawn.
enum class ProgressBarMode { on_terminals, always, never };

/// The Progress of the process. Draws a bar with an estimate of the remaining time on stderr, by
/// default if stderr is a terminal. Call it once.
Progress& terminal_progress(ProgressBarMode shown);

/// Makes Ctrl-C (SIGINT) and SIGTERM cancel the Progress of the process. Before one exists they end
/// the process with a message. A second signal kills the process.
void install_signal_handlers();

/// Ends the line of a visible bar. Call it before other output.
void clear_progress_bar();

}  // namespace vug::cli
