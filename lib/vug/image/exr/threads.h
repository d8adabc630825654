// SPDX-License-Identifier: Apache-2.0
// Internal to image/: the threads of OpenEXR.
#pragma once

namespace vug::image::exr {

/// OpenEXR compresses and decompresses on its own threads, whose number belongs to the process: a
/// program that has set it keeps it; otherwise it becomes thread_count(). The thread sanitizer
/// cannot follow these threads, so its builds have none.
void start_threads();

}  // namespace vug::image::exr
