// SPDX-License-Identifier: Apache-2.0
// Interface of rules: the transition from the current state of a cell and its neighbours to its
// next state. All cells are updated synchronously; values written are read in the next pass.
#pragma once

#include <vug/base/kind.h>
#include <vug/cells/pass.h>

#include <memory>

/// Opens the one definition exported by the file of a rule; see VUG_EXPORT_KIND.
#define VUG_RULE_KIND(name) VUG_EXPORT_KIND(vug::cells, RuleKind, name##_rule)

namespace vug::cells {

class Rule {
 public:
  virtual ~Rule() = default;
  /// Performs one step for all receiving cells: requests attributes from the pass and runs a
  /// kernel.
  virtual void step(Pass& pass) const = 0;
  /// Whether the default number of steps is one.
  virtual bool is_single_step() const { return false; }
  /// The attributes used by masks among its parameters.
  virtual paint::AttributeUses mask_attributes() const { return {}; }
};

using RulePtr = std::shared_ptr<const Rule>;
using RuleKind = Kind<RulePtr>;

const Kinds<RulePtr>& rules();

/// A kind whose parameter struct P has `static void describe(Schema<P>&)` and `void step(Pass&)
/// const`; with `static constexpr bool kSingleStep = true` it is for a single step, with
/// `paint::AttributeUses mask_attributes() const` it has masks.
template <class P>
RuleKind rule_kind(std::string name) {
  struct RuleAdapter final : Rule {
    explicit RuleAdapter(const P& p) : params(p) {}
    void step(Pass& pass) const override { params.step(pass); }
    bool is_single_step() const override {
      return requires { P::kSingleStep; };
    }
    paint::AttributeUses mask_attributes() const override {
      if constexpr (requires(const P& p) { p.mask_attributes(); }) return params.mask_attributes();
      return {};
    }
    P params;
  };
  return make_kind<RulePtr, P>(std::move(name), "rule",
                               [](const P& p) { return std::make_shared<const RuleAdapter>(p); });
}

}  // namespace vug::cells

namespace vug {

template <>
struct ValueTraits<cells::RulePtr> : ObjectTraits<cells::RulePtr> {
  static constexpr const char* kWord = "rule";
};

}  // namespace vug
