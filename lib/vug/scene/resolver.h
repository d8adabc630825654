// What the evaluator asks of whoever knows objects: names, calls and operators it does not know.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/base/rng.h>
#include <vug/base/schema.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::scene {

/// Every answer may be "not mine" (nullopt); the evaluator then reports the fault itself, with
/// a suggestion from the known names. An answer that went wrong is Value() with a diagnostic
/// added; it silences whatever uses it. The default knows nothing.
class Resolver {
 public:
  virtual ~Resolver() = default;

  /// A declared object, e.g. a grammar or a volume. Names nobody knows become Value::Name
  /// (enumerators such as `triangle`, directions such as `+X`).
  virtual std::optional<Value> name(const std::string& name, const SourceLocation& where,
                                    Diagnostics& diagnostics);
  /// A function that is not built in. `key` is this call's own place for seeded choice.
  virtual std::optional<Value> call(const std::string& name, const Arguments& arguments,
                                    const SourceLocation& where, RandomKey key,
                                    Diagnostics& diagnostics);
  /// True where the argument of a call, given by name or (with an empty one) by position, has the
  /// word among its choices: the word then stands for itself, whatever is declared under it.
  virtual bool is_choice(const std::string& call, size_t position, const std::string& argument,
                         const std::string& word) const;
  /// `op` is one of + - & * / ^ where at least one side is an object.
  virtual std::optional<Value> binary(char op, const Value& a, const Value& b,
                                      const SourceLocation& where, Diagnostics& diagnostics);
  /// `op` is - or + before an object.
  virtual std::optional<Value> unary(char op, const Value& a, const SourceLocation& where,
                                     Diagnostics& diagnostics);

  virtual std::vector<std::string> known_names() const { return {}; }
  virtual std::vector<std::string> known_calls() const { return {}; }

  /// Names that wait for one another; more is a text made by a program gone wrong.
  static constexpr int kMaxPending = 200;

  /// Counts how often a value was read that depends on the frame: what is made without any such
  /// reading is the same in every frame.
  void use_frame() { ++frame_uses_; }
  uint64_t frame_uses() const { return frame_uses_; }

 private:
  uint64_t frame_uses_ = 0;
};

}  // namespace vug::scene
