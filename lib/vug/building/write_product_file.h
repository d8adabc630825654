// SPDX-License-Identifier: Apache-2.0
// Internal to building/: writes the file of a product.
#pragma once

#include <vug/base/error.h>

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

namespace vug::building {

/// Calls `write` with the stream of the file. Error(io) if something could not be written.
template <class Write>
void write_product_file(const std::filesystem::path& target, const Write& write) {
  std::ofstream out(target, std::ios::binary);
  write(out);
  if (!out.flush()) throw Error(ErrorCode::io, fmt::format("cannot write '{}'", target.string()));
}

}  // namespace vug::building
