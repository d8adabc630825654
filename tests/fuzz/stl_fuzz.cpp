// SPDX-License-Identifier: Apache-2.0
// For any bytes, the STL reader returns a valid mesh or fails with bad_input.
#include "target.h"

#include <vug/base/error.h>
#include <vug/mesh/format.h>

#include <cstdint>
#include <cstdlib>

VUG_FUZZ_TARGET(stl) {
  static const vug::mesh::Format& format = vug::mesh::format_of("fuzz.stl");
  try {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    vug::mesh::validate(format.read(bytes, "fuzz.stl"), "what the reader made");
  } catch (const vug::Error& error) {
    const bool refused = error.code() == vug::ErrorCode::bad_input;
    if (!refused || error.where().file != "fuzz.stl") std::abort();
  }
}
