// Memory of large arrays.
#pragma once

#include <cstddef>

namespace vug::lsystem {

/// Unset memory; Error(too_large) where there is none. From 1 MiB on it comes from the system in
/// pages of 2 MiB, where they are to be had: a step that writes a new word would spend a third of
/// its time on being given small ones.
void* pages_for(size_t bytes);
void return_pages(void* place, size_t bytes);

}  // namespace vug::lsystem
