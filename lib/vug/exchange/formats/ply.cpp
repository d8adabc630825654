// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/flat_mesh.h>

VUG_EXCHANGE_FORMAT(ply) {
  return {{"ply",
           "exchange format",
           "Stanford polygons, all in one mesh: positions, normals, colours and every attribute",
           "turk1994",
           {}},
          std::nullopt,
          false,
          write_flat_mesh,
          read_flat_metadata};
}
