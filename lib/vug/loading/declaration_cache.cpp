// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/declaration_cache.h>
#include <vug/shot/move_lines.h>

namespace vug::loading {

using scene::DeclarationName;

DeclarationCache::DeclarationCache(ReadContext& context)
    : cache_(context.options.static_cache), reading_(context) {
  if (!cache_) return;
  cache_->reused = 0;
  digests_.emplace(context.document, context.options.include_folders);
  Hasher texts;
  for (const auto& source : context.document.sources)
    texts.add_value(source->text.size()).add(source->text);
  for (const scene::Declaration& each : context.document.declarations)
    extents_[{each.kind, each.name}] = each.extent;
  for (const scene::Grammar& each : context.document.grammars)
    extents_[{"grammar", each.name}] = each.extent;
  for (const auto& [name, extent] : extents_)  // with the files that they name
    if (const std::optional<Digest> known = inputs(name)) texts.add_value(*known);
  whole_ = texts.finish();
}

std::optional<Digest> DeclarationCache::inputs(const DeclarationName& name) const {
  return digests_->find(name.first, scene::name_without_index(name.second));
}

bool DeclarationCache::is_current(const DeclarationName& name) {
  const auto [at, is_new] = current_.try_emplace(name, false);
  if (!is_new) return at->second;
  const auto entry = cache_->declarations.find(name);
  if (entry == cache_->declarations.end()) return false;
  const Digest& known = entry->second.inputs;
  if (!(known == whole_) && !(inputs(name) == known)) return false;
  for (const auto& [used, number] : entry->second.uses)
    if (!is_current(used) || cache_->declarations.at(used).number != number) return false;
  return current_[name] = true;
}

Value DeclarationCache::reuse(StaticCache::Entry& entry, const DeclarationName& name) {
  // In the order of a first evaluation, which is that of the lists of the shot.
  for (const auto& [used, number] : entry.uses)
    reading_.resolver.declared(used.first, used.second, entry.extent, reading_.diagnostics);
  ++cache_->reused;
  const SourceLocation& now = extents_[{name.first, scene::name_without_index(name.second)}];
  shot::move_lines(entry.shot, entry.extent, now.line - entry.extent.line, moved_);
  entry.extent = now;
  shot::Shot& shot = reading_.shot;
  shot.add(entry.shot);
  if (entry.text_digest) shot.text_digest = *entry.text_digest;
  snapshot_ = shot.snapshot();
  return entry.value;
}

Value DeclarationCache::operator()(const std::string& kind, const std::string& name,
                                   const std::function<Value()>& make) {
  if (!cache_) return make();
  const DeclarationName both(kind, name);
  if (is_current(both)) return reuse(cache_->declarations.at(both), both);
  const Recording recording(*this, kind, name);
  snapshot_ = reading_.shot.snapshot();
  const Value value = make();
  recording.keep(value, snapshot_);
  snapshot_ = reading_.shot.snapshot();
  return value;
}

void DeclarationCache::forget_others() {
  if (!cache_) return;
  std::erase_if(cache_->declarations, [&](const auto& entry) {
    const auto current = current_.find(entry.first);
    return current == current_.end() || !current->second;
  });
}

struct DeclarationCache::Recording::State {
  explicit State(ReadContext& context)
      : used(context.resolver),
        frame_uses(context.resolver.frame_uses()),
        whole_text_uses(context.resolver.whole_text_uses()),
        faults(context.diagnostics.all().size()),
        texts(context.shot.text_digest) {}

  scene::Resolver::UseScope used;
  uint64_t frame_uses, whole_text_uses;
  size_t faults;
  Digest texts;
};

DeclarationCache::Recording::Recording(DeclarationCache& cache, const std::string& kind,
                                       std::string name)
    : cache_(cache), name_(kind, std::move(name)) {
  if (cache.cache_) state_ = std::make_unique<State>(cache.reading_);
}

DeclarationCache::Recording::~Recording() = default;

std::vector<DeclarationName> DeclarationCache::Recording::uses() const {
  return state_ ? state_->used.uses() : std::vector<DeclarationName>();
}

void DeclarationCache::Recording::keep(const Value& value,
                                       const shot::Shot::Snapshot& before) const {
  if (!state_) return;
  const ReadContext& reading = cache_.reading_;
  if (value.empty() || reading.resolver.frame_uses() != state_->frame_uses) return;
  const bool clean = reading.diagnostics.all().size() == state_->faults &&
                     reading.resolver.whole_text_uses() == state_->whole_text_uses;
  const std::optional<Digest> inputs = clean ? cache_.inputs(name_) : cache_.whole_;
  if (!inputs) return;
  auto& known = cache_.cache_->declarations;
  StaticCache::Entry made;
  made.value = value;
  made.shot = reading.shot.delta(before);
  if (!(reading.shot.text_digest == state_->texts)) made.text_digest = reading.shot.text_digest;
  made.inputs = *inputs;
  for (const DeclarationName& used : state_->used.uses()) {
    const auto entry = known.find(used);
    const bool current = entry != known.end() && cache_.is_current(used);
    made.uses.emplace_back(used, current ? entry->second.number : 0);
  }
  made.extent = cache_.extents_[{name_.first, scene::name_without_index(name_.second)}];
  made.number = ++cache_.cache_->last_number;
  known[name_] = std::move(made);
  cache_.current_[name_] = true;
}

void DeclarationCache::Recording::keep_loop() const {
  // A loop that is known keeps its number, and so do the declarations that use it.
  if (state_ && !cache_.is_current(name_)) keep(Value(true), cache_.reading_.shot.snapshot());
}

}  // namespace vug::loading
