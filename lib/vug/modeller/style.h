// The grammar that is modelled with: its rules by name, and the actions they come to.
#pragma once

#include <vug/facade/derive.h>
#include <vug/scene/document.h>
#include <vug/scene/resolver.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vug::modeller {

/// What one button does, whatever the symbol: the rules whose right sides are the same but for
/// parts at their end, and behind a symbol that only ends in elements the rules of that one too
/// (ripperda2009, section 5).
struct Action {
  std::string name;        ///< "repeat(RepeatedFacade)", "RegularGrid"
  std::vector<int> rules;  ///< Index in Rules::rules, in order of the text.
};

class Style;
using StylePtr = std::shared_ptr<const Style>;

/// Immutable, but for one thread at a time where its resolver is.
class Style {
 public:
  /// Of the document's grammar of that name; without one it has only one of kind facade.
  /// Error(bad_input) with the first fault of the text. The resolver knows what lets may hold.
  static StylePtr make(scene::Document document, const std::string& grammar = "",
                       std::shared_ptr<scene::Resolver> resolver = nullptr);

  const std::string& name() const { return rules_.name; }
  const facade::Rules& rules() const { return rules_; }
  const facade::Rule& rule(int index) const { return rules_.rules.at(static_cast<size_t>(index)); }
  /// Width and height in metres that the grammar's block asks for.
  std::optional<double> usual_width() const { return width_; }
  std::optional<double> usual_height() const { return height_; }

  /// The right side of a rule; where several of one symbol are alike with its number among the
  /// symbol's rules: "rows(Base, Rest) #2".
  std::string rule_name(int index) const;
  /// The rule of the symbol that is called so: by rule_name, by "Symbol -> ...", by "#2" or by its
  /// first word alone where no other begins so. Error(bad_input) with the nearest.
  int find_rule(const std::string& symbol, const std::string& called) const;
  /// Rules that divide the symbol.
  std::vector<int> rules_of(const std::string& symbol) const;

  const std::vector<Action>& actions() const { return actions_; }
  /// Whether all rules of the symbol come to nothing but elements.
  bool ends_in_elements(const std::string& symbol) const;
  /// What a rule gives its whole rectangle to: the one symbol on its right side, if it is that.
  std::optional<std::string> passes_to(int rule) const;

  /// Derives by the plan. InfeasiblePlan where it cannot be followed, Error(bad_input) where the
  /// text is at fault, Error(too_large) beyond the limits.
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
