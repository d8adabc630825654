// The resolver that knows every kind and every declaration of a document.
#pragma once

#include <vug/loading/kind_registry.h>
#include <vug/scene/document.h>
#include <vug/scene/evaluator.h>
#include <vug/scene/resolver.h>

#include <functional>
#include <map>
#include <string>

namespace vug::loading {

/// What a maker can be asked of arguments some of which have no value, because of faults that have
/// been told: those with a value whose parameter is sure.
struct ValidArguments {
  explicit ValidArguments(const Arguments& given);
  /// What a maker found of them. When they are not whole, what it says of its own place (that
  /// something is missing or does not fit together) is not known.
  void report(const Diagnostics& found, const SourceLocation& where,
              Diagnostics& diagnostics) const;

  Arguments arguments;
  bool complete = true;
};

class Resolver final : public scene::Resolver {
 public:
  /// Makes the value of a declared name, once, when it is first needed.
  using Factory = std::function<Value()>;

  /// Announces a declared object. Kinds have rooms of names of their own (the parser checks).
  void declare(const std::string& kind, const std::string& name, Factory factory);

  /// What that kind declares under the name; nothing when it declares none.
  std::optional<Value> declared(const std::string& kind, const std::string& name,
                                const SourceLocation& where, Diagnostics& diagnostics);

  /// A call of a kind of one family, where a declaration says which family it wants: names such
  /// as `sphere` stand for a solid and for a light.
  std::optional<Value> make(const KindRegistry& registry, const std::string& name,
                            const Arguments& arguments, const SourceLocation& where,
                            Diagnostics& diagnostics);

  /// Of several kinds that declare the name, the first; inside of its declaration, the next.
  std::optional<Value> name(const std::string& name, const SourceLocation& where,
                            Diagnostics& diagnostics) override;
  std::optional<Value> call(const std::string& name, const Arguments& arguments,
                            const SourceLocation& where, RandomKey key,
                            Diagnostics& diagnostics) override;
  bool is_choice(const std::string& call, size_t position, const std::string& argument,
                 const std::string& word) const override;
  std::optional<Value> binary(char op, const Value& a, const Value& b, const SourceLocation& where,
                              Diagnostics& diagnostics) override;
  std::optional<Value> unary(char op, const Value& a, const SourceLocation& where,
                             Diagnostics& diagnostics) override;
  std::vector<std::string> known_names() const override;
  std::vector<std::string> known_calls() const override;

 private:
  struct Entry {
    std::string kind;
    std::vector<Factory> factories;  ///< More than one is a fault, and then there is no value.
    Value value;
    bool evaluated = false;
    bool pending = false;
    bool frame_dependent = false;  ///< The value depends on the frame.
  };
  Value value(Entry& entry, const std::string& name, const SourceLocation& where,
              Diagnostics& diagnostics);

  std::map<std::string, std::vector<Entry>> entries_;  ///< In the order of the text.
  int pending_ = 0;  ///< Entries that are being made: each is made for the one before.
};

}  // namespace vug::loading
