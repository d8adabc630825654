// SPDX-License-Identifier: Apache-2.0
// The resolver of all kinds and all declarations of a document.
#pragma once

#include <vug/loading/kind_registry.h>
#include <vug/loading/provenance.h>
#include <vug/scene/document.h>
#include <vug/scene/evaluator.h>
#include <vug/scene/resolver.h>

#include <functional>
#include <map>
#include <string>

namespace vug::loading {

/// The usable arguments of a call. Arguments without a value, due to faults that have been
/// reported, are removed, as are positional ones whose parameter is therefore unknown.
struct ValidArguments {
  explicit ValidArguments(const Arguments& given);
  /// Passes on the diagnostics of a factory. If arguments were removed, diagnostics at `where`
  /// itself (something is missing or does not fit together) are dropped, as they may be
  /// consequences.
  void report(const Diagnostics& found, const SourceLocation& where,
              Diagnostics& diagnostics) const;

  Arguments arguments;
  bool complete = true;
};

class Resolver final : public scene::Resolver {
 public:
  /// Computes the value of a declaration; called once, when the value is first needed.
  using Factory = std::function<Value()>;

  Resolver() = default;
  explicit Resolver(const scene::Document& document) : provenance_(document) {}

  /// Registers a declaration. Each kind has its own namespace; the parser checks for duplicates.
  void declare(const std::string& kind, const std::string& name, Factory factory);

  std::optional<Value> declared(const std::string& kind, const std::string& name,
                                const SourceLocation& where, Diagnostics& diagnostics) override;
  std::string_view expected_type(const std::string& call, size_t position,
                                 const std::string& argument) const override;

  /// Calls a kind of one registry, for declarations that determine the registry: a name such as
  /// `sphere` is both a solid and a light.
  std::optional<Value> make(const KindRegistry& registry, const std::string& name,
                            const Arguments& arguments, const SourceLocation& where,
                            Diagnostics& diagnostics);

  /// The value of the first declaration of that name; inside that declaration, of the next one.
  std::optional<Value> name(const std::string& name, const SourceLocation& where,
                            Diagnostics& diagnostics) override;
  std::optional<Value> call(const std::string& name, const Arguments& arguments,
                            const SourceLocation& where, const CallContext& context,
                            Diagnostics& diagnostics) override;
  bool is_choice(const std::string& call, size_t position, const std::string& argument,
                 const std::string& word) const override;
  bool is_word(const std::string& word) const override;
  std::optional<Value> binary(char op, const Value& a, const Value& b, const SourceLocation& where,
                              Diagnostics& diagnostics) override;
  std::optional<Value> unary(char op, const Value& a, const SourceLocation& where,
                             Diagnostics& diagnostics) override;
  std::vector<std::string> known_names() const override;
  std::vector<std::string> known_calls() const override;
  std::string call_for(const std::string& word) const override;
  std::string include_with(const std::string& function) const override;

  /// Records that the value was made by the text at `where`, if it is a field, and the files of a
  /// network.
  void record(const Value& value, const SourceLocation& where);
  ProvenanceTable& provenance() { return provenance_; }

 private:
  struct Entry {
    std::string kind;
    std::vector<Factory> factories;  ///< More than one is an error, without a value.
    Value value;
    bool evaluated = false;
    bool pending = false;
    bool frame_dependent = false;  ///< The value depends on the frame.
  };
  Value value(Entry& entry, const std::string& name, const SourceLocation& where,
              Diagnostics& diagnostics);

  std::map<std::string, std::vector<Entry>> entries_;  ///< Per name in the order of the text.
  ProvenanceTable provenance_;
  int pending_ = 0;  ///< Nesting depth of the entries being evaluated.
};

}  // namespace vug::loading
