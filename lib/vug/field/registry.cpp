// SPDX-License-Identifier: Apache-2.0
#include <vug/field/registry.h>

namespace vug::field {

const Kinds<Field>& field_kinds() {
  static const Kinds<Field> kinds = [] {
    Kinds<Field> all = primitives();
    all.insert(all.end(), operators().begin(), operators().end());
    all.insert(all.end(), deformers().begin(), deformers().end());
    all.insert(all.end(), details().begin(), details().end());
    return all;
  }();
  return kinds;
}

Field make(const std::string& kind, const NamedValues& params) {
  return make_product(field_kinds(), kind, params);
}

}  // namespace vug::field
