// SPDX-License-Identifier: Apache-2.0
// Interface through which the evaluator resolves names, calls and operators of objects.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/base/rng.h>
#include <vug/base/schema.h>
#include <vug/scene/declaration_uses.h>
#include <vug/scene/provenance.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vug::scene {

/// Every method may return nullopt for "unknown"; the evaluator then reports the error with a
/// suggestion from the known names. After an error of its own, a method adds a diagnostic and
/// returns Value(), which suppresses errors of dependent expressions. The default implementation
/// knows nothing.
class Resolver {
 public:
  virtual ~Resolver() = default;

  /// A declared object, e.g. a grammar or a volume. Unknown names become Value::Name (enumerators
  /// such as `triangle`, directions such as `+X`).
  virtual std::optional<Value> name(const std::string& name, const SourceLocation& where,
                                    Diagnostics& diagnostics);
  /// The declaration of that kind and name; nothing if there is none.
  virtual std::optional<Value> declared(const std::string& kind, const std::string& name,
                                        const SourceLocation& where, Diagnostics& diagnostics);
  /// The type of object that an argument of a call must have, given by name or (if the name is
  /// empty) by position; empty if it is unknown.
  virtual std::string_view expected_type(const std::string& call, size_t position,
                                         const std::string& argument) const;
  /// The circumstances of a call.
  struct CallContext {
    RandomKey key;              ///< Determines the random choices of this call.
    std::string_view expected;  ///< The type of object that the value must have; empty: any.
  };
  /// A function that is not built in.
  virtual std::optional<Value> call(const std::string& name, const Arguments& arguments,
                                    const SourceLocation& where, const CallContext& context,
                                    Diagnostics& diagnostics);
  /// True if the word is a valid choice for the argument of a call, given by name or (if the name
  /// is empty) by position. The word is then not looked up among the declarations.
  virtual bool is_choice(const std::string& call, size_t position, const std::string& argument,
                         const std::string& word) const;
  /// `op` is one of + - & * / ^; at least one operand is an object.
  virtual std::optional<Value> binary(char op, const Value& a, const Value& b,
                                      const SourceLocation& where, Diagnostics& diagnostics);
  /// `op` is - or + before an object.
  virtual std::optional<Value> unary(char op, const Value& a, const SourceLocation& where,
                                     Diagnostics& diagnostics);

  /// True if the word is a valid choice for some argument or entry, or another word of a kind.
  virtual bool is_word(const std::string& word) const;

  virtual std::vector<std::string> known_names() const { return {}; }
  virtual std::vector<std::string> known_calls() const { return {}; }
  /// The call that other programs name with this word, for suggestions; empty if there is none.
  virtual std::string call_for(const std::string& /*word*/) const { return {}; }
  /// The include that declares a function of that name, as "kit/lamps.vug"; empty if there is none.
  virtual std::string include_with(const std::string& /*function*/) const { return {}; }

  /// Maximum number of names that depend on one another in a chain.
  static constexpr int kMaxPending = 200;

  /// Counts uses of values that depend on the frame; a product made without such a use is the same
  /// in every frame.
  void use_frame() { ++frame_uses_; }
  uint64_t frame_uses() const { return frame_uses_; }
  /// Counts uses of declarations that the text does not mention by name, such as all objects so
  /// far.
  void use_whole_text() { ++whole_text_uses_; }
  uint64_t whole_text_uses() const { return whole_text_uses_; }

  /// For its lifetime, collects the declarations that are used; those outside of it include them.
  class UseScope {
   public:
    explicit UseScope(Resolver& resolver)
        : resolver_(resolver), outer_(std::exchange(resolver.uses_, &uses_)) {}
    ~UseScope() {
      resolver_.uses_ = outer_;
      if (outer_) outer_->add(uses_.list());
    }
    UseScope(const UseScope&) = delete;
    UseScope& operator=(const UseScope&) = delete;

    const std::vector<DeclarationName>& uses() const { return uses_.list(); }

   private:
    Resolver& resolver_;
    DeclarationUses uses_;
    DeclarationUses* outer_;
  };
  /// Records the use of declarations for the innermost UseScope, if there is one.
  template <class Used>
  void record_use(const Used& used) {
    if (uses_) uses_->add(used);
  }

  /// The declarations, names and rules that are being evaluated, for a FrameScope.
  FramePtr& frames() { return frames_; }

 private:
  FramePtr frames_;
  uint64_t frame_uses_ = 0;
  uint64_t whole_text_uses_ = 0;
  DeclarationUses* uses_ = nullptr;
};

}  // namespace vug::scene
