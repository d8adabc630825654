// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/flat_mesh.h>

VUG_EXCHANGE_FORMAT(obj) {
  return {{"obj",
           "exchange format",
           "Wavefront text, all in one mesh: positions, normals and colours",
           "wavefront1995",
           {}},
          std::nullopt,
          false,
          write_flat_mesh,
          read_flat_metadata};
}
