// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/exchange/usd_crate.h>
#include <vug/exchange/usd_file.h>
#include <vug/exchange/usd_text.h>
#include <vug/mesh/file.h>

namespace vug::exchange {

void write_usd_file(const std::filesystem::path& file,
                    const std::function<void(UsdLayer&)>& write) {
  if (extension_of(file) == ".usdc")
    return mesh::write_file_with_header(file, [&](const mesh::ByteSink& sink) {
      UsdCrate layer(sink);
      write(layer);
      layer.finish();
      return layer.file_header();
    });
  mesh::write_file(file, [&](const mesh::ByteSink& sink) {
    UsdText layer(sink);
    write(layer);
    layer.finish();
  });
}

}  // namespace vug::exchange
