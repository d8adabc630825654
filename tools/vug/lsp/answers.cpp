// SPDX-License-Identifier: Apache-2.0
#include "lsp/server.h"

namespace vug::lsp {

const Answers& answers() {
  static const Answers all = [] {
    Answers made;
    add_navigation(made);
    add_editing(made);
    add_structure(made);
    return made;
  }();
  return all;
}

}  // namespace vug::lsp
