// SPDX-License-Identifier: Apache-2.0
// The operands of a fold. A restricted fold shares those that it does not change with the fold from
// which it comes: unions of thousands of solids are restricted for every cell of an octree.
#pragma once

#include <vug/field/fold_operand.h>

#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace vug::field {

class OperandList {
 public:
  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = Operand;
    using difference_type = std::ptrdiff_t;
    using pointer = const Operand*;
    using reference = const Operand&;
    Iterator() = default;
    explicit Iterator(const Operand* const* at) : at_(at) {}
    reference operator*() const { return **at_; }
    pointer operator->() const { return *at_; }
    Iterator& operator++() { return ++at_, *this; }
    Iterator operator++(int) { return Iterator(at_++); }
    bool operator==(const Iterator& other) const { return at_ == other.at_; }

   private:
    const Operand* const* at_ = nullptr;
  };

  OperandList(std::vector<Operand> own) : OperandList(std::move(own), nullptr) {
    for (const Operand& operand : store_->own) all_.push_back(&operand);
  }
  /// An empty list for `count` operands of another list, of which `changed` become smaller.
  OperandList(const OperandList& whole, size_t count, size_t changed)
      : OperandList({}, changed < count ? whole.store_ : nullptr) {
    all_.reserve(count);
    store_->own.reserve(changed);
  }
  /// Appends an operand of the other list.
  void share(const Operand& operand) { all_.push_back(&operand); }
  /// Appends an operand of the other list with a smaller node. At most `changed` times.
  void replace(NodePtr smaller, const Operand& operand) {
    all_.push_back(&store_->own.emplace_back(std::move(smaller), operand));
  }

  size_t size() const { return all_.size(); }
  const Operand& operator[](size_t i) const { return *all_[i]; }
  Iterator begin() const { return Iterator(all_.data()); }
  Iterator end() const { return Iterator(all_.data() + all_.size()); }

 private:
  /// Operands, and those that others share with them.
  struct Store {
    std::vector<Operand> own;
    std::shared_ptr<const Store> shared;
  };
  OperandList(std::vector<Operand> own, std::shared_ptr<const Store> shared)
      : store_(std::make_shared<Store>(Store{std::move(own), std::move(shared)})) {}

  std::shared_ptr<Store> store_;
  std::vector<const Operand*> all_;
};

}  // namespace vug::field
