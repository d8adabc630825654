// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/document.h>

namespace vug::scene {

namespace {

template <class T>
const T* find_named(const std::vector<T>& all, const std::string& name) {
  for (const T& one : all)
    if (one.name == name) return &one;
  return nullptr;
}

}  // namespace

std::string name_without_index(const std::string& element) {
  return element.substr(0, element.find('['));
}

const Param* Document::find_param(const std::string& name) const {
  return find_named(params, name);
}

const Let* Document::find_let(const std::string& name) const { return find_named(lets, name); }

const ImportedModule* Document::find_module(const std::string& name) const {
  return find_named(modules, name);
}

const Declaration* Document::find(const std::string& name, const std::string& kind) const {
  const std::string declared = name_without_index(name);
  for (const Declaration& one : declarations)
    if (one.name == declared && (kind.empty() || one.kind == kind)) return &one;
  return nullptr;
}

}  // namespace vug::scene
