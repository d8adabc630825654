// Progress on a terminal, and Ctrl-C as a polite request.
#pragma once

#include <vug/base/progress.h>

namespace vug::cli {

/// The process's Progress: draws a bar with an estimate of the time left on stderr when that is
/// a terminal and `quiet` is off; Ctrl-C (SIGINT) and SIGTERM cancel it. Call once.
Progress& terminal_progress(bool quiet);

/// Ends the line a bar may stand on, before other output.
void clear_bar();

}  // namespace vug::cli
