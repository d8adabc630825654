// SPDX-License-Identifier: Apache-2.0
// Internal to image/: what libpng calls for errors and warnings, which it would print otherwise.
// Includes libpng.
#pragma once

#include <png.h>

namespace vug::image {

/// Continues at the setjmp of png_jmpbuf.
[[noreturn]] inline void jump_out(png_structp png, png_const_charp) { png_longjmp(png, 1); }
inline void ignore_warning(png_structp, png_const_charp) {}

}  // namespace vug::image
