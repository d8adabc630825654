// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/image/exr/threads.h>

#include <OpenEXR/ImfThreading.h>

namespace vug::image::exr {

void start_threads() {
#ifndef __SANITIZE_THREAD__
  if (Imf::globalThreadCount() == 0) Imf::setGlobalThreadCount(thread_count());
#endif
}

}  // namespace vug::image::exr
