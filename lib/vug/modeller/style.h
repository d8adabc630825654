// SPDX-License-Identifier: Apache-2.0
// The grammar used for modelling: its rules by name, and the actions derived from them.
#pragma once

#include <vug/facade/derive.h>
#include <vug/scene/document.h>
#include <vug/scene/resolver.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vug::modeller {

/// The effect of one button, independent of the symbol: rules whose right sides differ only in
/// their last parts. If such a rule leads to a symbol that only ends in elements, the action
/// includes a rule of that symbol as well (ripperda2009, section 5).
struct Action {
  std::string name;        ///< For example "repeat(RepeatedFacade)" or "RegularGrid".
  std::vector<int> rules;  ///< Indices in Rules::rules, in order of the text.
};

class Style;
using StylePtr = std::shared_ptr<const Style>;

/// Immutable; the resolver restricts it to one thread at a time.
class Style {
 public:
  /// Uses the grammar of that name in the document; by default the only grammar of kind facade.
  /// Error(bad_input) with the first fault of the text. The resolver knows the values that `let`
  /// may hold.
  static StylePtr make(scene::Document document, const std::string& grammar = "",
                       std::shared_ptr<scene::Resolver> resolver = nullptr);

  const std::string& name() const { return rules_.name; }
  const facade::Rules& rules() const { return rules_; }
  const facade::Rule& rule(int index) const { return rules_.rules.at(static_cast<size_t>(index)); }
  /// Width and height in metres requested by the grammar's block.
  std::optional<double> usual_width() const { return width_; }
  std::optional<double> usual_height() const { return height_; }

  /// The right side of a rule, followed by its number among the symbol's rules if several are
  /// equal: "rows(Base, Rest) #2".
  std::string rule_name(int index) const;
  /// Finds a rule of the symbol by rule_name, by "Symbol -> ...", by "#2", or by its first word if
  /// that is unambiguous. Error(bad_input) suggests the nearest name.
  int find_rule(const std::string& symbol, const std::string& called) const;
  /// Rules that divide the symbol.
  std::vector<int> rules_of(const std::string& symbol) const;

  const std::vector<Action>& actions() const { return actions_; }
  /// Whether all rules of the symbol consist of elements only.
  bool ends_in_elements(const std::string& symbol) const;
  /// The symbol that a rule passes its whole rectangle to: the right side, if it is a single
  /// symbol.
  std::optional<std::string> passes_to(int rule) const;

  /// Derives the facade by the plan. Throws InfeasiblePlan if the plan cannot be followed,
  /// Error(bad_input) for faults of the text, and Error(too_large) beyond the limits.
  facade::PlannedDerivation derive(const facade::DeriveOptions& options,
                                   const facade::PlanOptions& planning) const;

 private:
  Style(scene::Document document, std::shared_ptr<scene::Resolver> resolver)
      : document_(std::move(document)), resolver_(std::move(resolver)) {}
  void read(const std::string& grammar);
  void read_size(const scene::Grammar& grammar);
  void collect_actions();

  scene::Document document_;
  std::shared_ptr<scene::Resolver> resolver_;
  facade::Rules rules_;
  std::optional<double> width_, height_;
  std::vector<Action> actions_;
};

}  // namespace vug::modeller
