// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/usd_file.h>
#include <vug/exchange/usd_text.h>
#include <vug/mesh/file.h>

namespace vug::exchange {

void write_usd_file(const std::filesystem::path& file,
                    const std::function<void(UsdLayer&)>& write) {
  mesh::write_file(file, [&](const mesh::ByteSink& sink) {
    UsdText layer(sink);
    write(layer);
    layer.finish();
  });
}

}  // namespace vug::exchange
