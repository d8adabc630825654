// SPDX-License-Identifier: Apache-2.0
// Runs work with the number of threads in a render's options.
#pragma once

#include <vug/base/parallel.h>
#include <vug/render/render.h>

namespace vug::render {

/// Runs `work` with the number of threads of the options; 0: with the current number.
template <class Work>
auto with_threads_of(const Options& options, const Work& work) {
  return options.threads > 0 ? with_threads(options.threads, work) : work();
}

}  // namespace vug::render
