// Faults that are found where the text is no longer at hand, told where it is at fault.
#pragma once

#include <vug/base/error.h>

namespace vug::session {

inline Error blamed_on(const SourceLocation& where, const Error& error) {
  return Error(error.code(), error.what(), where, error.hint());
}

}  // namespace vug::session
