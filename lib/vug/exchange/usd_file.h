// SPDX-License-Identifier: Apache-2.0
// Internal to exchange/: files of USD layers, as text or binary.
#pragma once

#include <vug/exchange/usd_layer.h>

#include <filesystem>
#include <functional>

namespace vug::exchange {

/// Calls `write` with a layer in the format of the file's extension: .usdc is binary, others are
/// text. The file is complete on return; if anything throws, the previous file remains unchanged.
/// Throws Error(io), Error(too_large).
void write_usd_file(const std::filesystem::path& file, const std::function<void(UsdLayer&)>& write);

}  // namespace vug::exchange
