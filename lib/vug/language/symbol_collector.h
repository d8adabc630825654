// SPDX-License-Identifier: Apache-2.0
// Inside the module: resolves the names of a document as its evaluation does.
#pragma once

#include <vug/base/schema.h>
#include <vug/language/symbols.h>
#include <vug/scene/lsystem_document.h>

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vug::language {

class SymbolCollector {
 public:
  explicit SymbolCollector(const scene::Document& document) : document_(document) {}
  SymbolTable run();

 private:
  using Locals = std::vector<std::pair<std::string, int>>;
  /// Forgets the local names that were added during its lifetime.
  class LocalScope {
   public:
    explicit LocalScope(Locals& locals) : locals_(locals), size_(locals.size()) {}
    ~LocalScope() { locals_.resize(size_); }
    LocalScope(const LocalScope&) = delete;
    LocalScope& operator=(const LocalScope&) = delete;

   private:
    Locals& locals_;
    size_t size_;
  };

  void declare_all();
  int add(Symbol symbol);
  void add_global(SymbolKind kind, const std::string& full, const char* keyword,
                  const SourceLocation& where, const SourceLocation& extent,
                  const std::string& doc = {});
  int add_local(SymbolKind kind, const scene::Formal& formal, const SourceLocation& scope);
  void refer(const SourceLocation& where, int symbol, bool declares = false);

  void function(const scene::Def& def);
  void declaration(const scene::Declaration& made);
  void variant(const scene::Declaration& made);
  void entry(const scene::Entry& entry, const ParamInfo* param, std::string_view otherwise);
  void grammar(const scene::Grammar& made);
  void rule(const scene::Rule& rule, const scene::Grammar& grammar);
  void item(const scene::Item& item, bool places);
  void lsystem(const scene::LSystem& system, const scene::Grammar& grammar);
  void production(const scene::Production& one);
  void word(const scene::ModuleString& word);
  void head(const std::string& name, const SourceLocation& where, const SourceLocation& extent);
  void locals(const std::vector<scene::Let>& locals, const SourceLocation& scope);
  void given_values();

  void expr(const scene::ExprPtr& expr, std::string_view expected = {});
  void call(const scene::Expr& expr, std::string_view expected);
  void comprehension(const scene::Expr& expr, std::string_view expected);
  void name(const scene::Expr& expr, std::string_view expected);
  int find_declared(const std::string& full, std::string_view type,
                    const SourceLocation& from) const;
  bool symbol_of_rule(const scene::Expr& expr);

  const scene::Document& document_;
  SymbolTable table_;
  std::map<std::string, int> globals_, functions_, modules_;  ///< By full name.
  std::map<std::string, std::vector<int>> declared_;          ///< By full name.
  std::map<std::string, int> heads_, tables_;                 ///< Those of the current grammar.
  Locals locals_;
  bool heads_are_values_ = false;  ///< In a facade, arguments may be symbols.
  int outer_ = -1;                 ///< The symbol of the current declaration.
};

}  // namespace vug::language
