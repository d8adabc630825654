// SPDX-License-Identifier: Apache-2.0
// The drips of a shot as products of a store: their graphs and what has grown from them.
#pragma once

#include <vug/building/stored_products.h>
#include <vug/shot/drips_plan.h>

#include <memory>
#include <mutex>

namespace vug::building {

template <>
struct ProductFile<drips::Graph> {
  static constexpr const char* kExtension = ".drips";
  static void write(const std::filesystem::path& target, const drips::Graph& graph);
  static drips::Graph read(const std::filesystem::path& source);
};
template <>
struct ProductFile<drips::GrownForms> {
  static constexpr const char* kExtension = ".forms";
  static void write(const std::filesystem::path& target, const drips::GrownForms& grown);
  static drips::GrownForms read(const std::filesystem::path& source);
};

/// Drips are computed when they are first needed, by any thread. This object takes their reports
/// and passes them on one at a time, while it lives.
class DripsReports {
 public:
  explicit DripsReports(std::function<void(const ProductReport&)> on_product)
      : on_product_(std::move(on_product)) {}
  void operator()(const ProductReport& report);

 private:
  std::mutex reporting_;
  std::function<void(const ProductReport&)> on_product_;
};

/// Makes all drips of the shot that have a name products of the store. Returns the receiver of
/// their reports, which the caller keeps as long as `use.on_product` may be called; null without a
/// store.
std::shared_ptr<DripsReports> store_drips(const shot::Shot& shot, const StoreUse& use);

}  // namespace vug::building
