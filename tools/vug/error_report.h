// How the command tells of errors.
#pragma once

#include <vug/base/error.h>

namespace vug::cli {

/// "error: message", its context and its hint on stderr; the exit code that goes with it.
int print_error(const Error& error);

/// Tells an error on stderr that stops nothing, and what that means.
void print_warning(const Error& error, const std::string& what);

}  // namespace vug::cli
