// Progress on a terminal, and Ctrl-C as a polite request.
#pragma once

#include <vug/base/progress.h>

namespace vug::cli {

enum class ProgressBarMode { on_terminals, always, never };

/// The process's Progress: draws a bar with an estimate of the time left on stderr, by default
/// when that is a terminal. Call once.
Progress& terminal_progress(ProgressBarMode shown);

/// From now on Ctrl-C (SIGINT) and SIGTERM cancel the process's Progress; before there is one they
/// end the process with a word. A second signal ends it the hard way.
void install_signal_handlers();

/// Ends the line a bar may stand on, before other output.
void clear_progress_bar();

}  // namespace vug::cli
