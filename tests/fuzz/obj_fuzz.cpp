// SPDX-License-Identifier: Apache-2.0
// For any bytes, the OBJ reader returns a valid mesh or fails with bad_input.
#include <vug/base/error.h>
#include <vug/mesh/format.h>

#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static const vug::mesh::Format& format = vug::mesh::format_of("fuzz.obj");
  try {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    vug::mesh::validate(format.read(bytes, "fuzz.obj"), "what the reader made");
  } catch (const vug::Error& error) {
    const bool refused = error.code() == vug::ErrorCode::bad_input;
    if (!refused || error.where().file != "fuzz.obj") std::abort();
  }
  return 0;
}
