// SPDX-License-Identifier: Apache-2.0
#include <vug/base/binary_value.h>
#include <vug/building/product_keys.h>
#include <vug/building/stopwatch.h>
#include <vug/building/stored_drips.h>
#include <vug/building/write_product_file.h>

namespace vug::building {
namespace {

template <class T>
void write_plain_product(const std::filesystem::path& target, const T& product) {
  write_product_file(target, [&](std::ostream& out) { write_value(out, product); });
}

template <class T>
T read_plain_product(const std::filesystem::path& source) {
  std::ifstream in(source, std::ios::binary);
  T out;
  read_value(in, out);
  return out;
}

/// The drips of one plan in a store.
class StoredDrips final : public shot::DripsCache {
 public:
  StoredDrips(StoreUse use, std::string name) : products_(std::move(use)), name_(std::move(name)) {}

  drips::Graph graph(const Digest& inputs, const std::function<drips::Graph()>& make) override {
    return obtain(drip_graph_key(inputs), make);
  }
  drips::GrownForms forms(const Digest& inputs,
                          const std::function<drips::GrownForms()>& make) override {
    return obtain(grown_forms_key(inputs), make);
  }

 private:
  template <class T>
  T obtain(const store::Key& key, const std::function<T()>& make) {
    double total = 0;
    const auto timed = [&](double& seconds) {
      const Stopwatch watch(seconds);
      return make();
    };
    return products_.obtain<T>(key, name_, timed, total);
  }

  StoredProducts products_;
  std::string name_;
};

}  // namespace

void ProductFile<drips::Graph>::write(const std::filesystem::path& target,
                                      const drips::Graph& graph) {
  write_plain_product(target, graph);
}

drips::Graph ProductFile<drips::Graph>::read(const std::filesystem::path& source) {
  return read_plain_product<drips::Graph>(source);
}

void ProductFile<drips::GrownForms>::write(const std::filesystem::path& target,
                                           const drips::GrownForms& grown) {
  write_plain_product(target, grown);
}

drips::GrownForms ProductFile<drips::GrownForms>::read(const std::filesystem::path& source) {
  return read_plain_product<drips::GrownForms>(source);
}

void DripsReports::operator()(const ProductReport& report) {
  const std::lock_guard lock(reporting_);
  if (on_product_) on_product_(report);
}

std::shared_ptr<DripsReports> store_drips(const shot::Shot& shot, const StoreUse& use) {
  if (!use.store) return nullptr;
  auto reports = std::make_shared<DripsReports>(use.on_product);
  StoreUse own = use;
  own.on_product = [weak = std::weak_ptr(reports)](const ProductReport& report) {
    if (const auto receiver = weak.lock()) (*receiver)(report);
  };
  for (const shot::NamedDrips& each : shot.drips)
    each.drips->keep_in(std::make_shared<StoredDrips>(own, each.name));
  return reports;
}

}  // namespace vug::building
