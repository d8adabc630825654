// SPDX-License-Identifier: Apache-2.0
// Printing of errors and warnings, and the exit code of an error.
#pragma once

#include <vug/base/error.h>

namespace vug::cli {

/// Prints "error: message", the error's context and its hint to stderr. Returns the exit code.
int print_error(const Error& error);

/// Prints an error that does not stop the program to stderr as a warning, followed by its
/// consequence `what`.
void print_warning(const Error& error, const std::string& what);

}  // namespace vug::cli
