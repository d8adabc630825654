// SPDX-License-Identifier: Apache-2.0
// For any bytes, the reader of partial renders and checkpoints returns one that can be developed
// into a picture, or fails with bad_input (too_large if it exceeds any memory).
#include "file_of_bytes.h"
#include "target.h"

#include <vug/base/error.h>
#include <vug/render/film/partial_render.h>

#include <cstdlib>

VUG_FUZZ_TARGET(part) {
  const auto& path = file_of_bytes(data, size, ".part");
  const auto refused = [&](const vug::Error& error) {
    if (error.code() != vug::ErrorCode::bad_input && error.code() != vug::ErrorCode::too_large)
      std::abort();
    if (std::string(error.what()).find(path.string()) == std::string::npos) std::abort();
  };
  try {
    const double fraction = vug::render::read_partial_render_info(path).fraction;
    if (!(fraction >= 0 && fraction <= 1)) std::abort();
  } catch (const vug::Error& error) {
    refused(error);
  }
  try {
    const vug::render::PartialRender part = vug::render::read_partial_render(path);
    if (part.state.region.empty()) std::abort();
    if (part.header.deep) vug::render::develop(part.state, *part.header.deep);
  } catch (const vug::Error& error) {
    refused(error);
  }
}
