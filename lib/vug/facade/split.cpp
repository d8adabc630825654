// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/split.h>

namespace vug::facade {

Value as_sizes(const Value& value) {
  if (const Number* number = value.get<Number>()) return ValueTraits<Size>::write({*number});
  const List* list = value.get<List>();
  if (!list) return value;
  List out;
  for (const Value& each : *list) out.push_back(as_sizes(each));
  return out;
}

}  // namespace vug::facade
