// SPDX-License-Identifier: Apache-2.0
// Evaluates the declarations of a text, or takes their values from the evaluation of another
// version of it or at another frame.
#pragma once

#include <vug/loading/reader.h>
#include <vug/scene/statement_digests.h>

#include <functional>
#include <map>
#include <optional>
#include <set>

namespace vug::loading {

/// A value is taken from LoadOptions::static_cache if its text has the same digest and all
/// declarations that it uses are taken as well, so that plans that refer to each other stay the
/// identical objects. Declarations with a warning, and those that read others which they do not
/// mention, are taken only if the whole text and the files that it names are the same.
class DeclarationCache {
 public:
  explicit DeclarationCache(ReadContext& context);

  /// The value of a declaration, `make()` if it is not known. A reader first evaluates its
  /// dependencies, which may be other declarations, and then adds its own plans to the shot.
  Value operator()(const std::string& kind, const std::string& name,
                   const std::function<Value()>& make);

  /// Removes the values that this text does not use.
  void forget_others();

  /// The evaluation of a declaration: collects what determines its value.
  class Recording {
   public:
    Recording(DeclarationCache& cache, const std::string& kind, std::string name);
    /// The evaluation of a loop.
    Recording(DeclarationCache& cache, const scene::Declaration& loop)
        : Recording(cache, loop.kind, loop.name) {}
    ~Recording();
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

    /// The declarations that were used so far.
    std::vector<scene::DeclarationName> uses() const;
    /// Adds the value and the additions to the shot since `before`, if it is the same in every
    /// frame.
    void keep(const Value& value, const shot::Shot::Snapshot& before) const;
    /// Adds a loop, whose elements have been kept, for the declarations that use it.
    void keep_loop() const;

   private:
    struct State;
    DeclarationCache& cache_;
    scene::DeclarationName name_;
    std::unique_ptr<State> state_;
  };

 private:
  /// The text that determines the value of a declaration; nothing if it is not at hand.
  std::optional<Digest> inputs(const scene::DeclarationName& name) const;
  bool is_current(const scene::DeclarationName& name);
  Value reuse(StaticCache::Entry& entry, const scene::DeclarationName& name);

  StaticCache* cache_;
  ReadContext& reading_;
  std::optional<scene::StatementDigests> digests_;
  Digest whole_;  ///< The digest of all texts and of the files that they name.
  std::map<scene::DeclarationName, SourceLocation> extents_;
  std::map<scene::DeclarationName, bool> current_;
  std::set<const SourceLocation*> moved_;  ///< See shot::move_lines.
  shot::Shot::Snapshot snapshot_;  ///< After the additions of the last evaluated declaration.
};

}  // namespace vug::loading
