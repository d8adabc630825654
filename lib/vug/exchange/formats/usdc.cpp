// SPDX-License-Identifier: Apache-2.0
// USD as a binary crate file: the same layer as .usda, with less text to parse.
#include <vug/exchange/crate_reader.h>
#include <vug/exchange/usd_writer.h>

VUG_EXCHANGE_FORMAT(usdc) {
  return {{"usdc",
           "exchange format",
           "USD in binary form: the same contents as .usda, smaller and faster to read",
           "usd",
           {}},
          std::nullopt,
          true,
          write_usd_assembly,
          read_crate_metadata,
          true};
}
