// SPDX-License-Identifier: Apache-2.0
#include <vug/store/layout.h>
#include <vug/store/maintenance.h>
#include <vug/store/remote.h>
#include <vug/store/store.h>

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>
#include <system_error>

namespace vug::store {

namespace fs = std::filesystem;

namespace {

constexpr uint64_t kDefaultBytes = 20'000'000'000;

uint64_t limit_for(const fs::path& folder) {
  std::error_code error;
  const fs::space_info disk = fs::space(folder, error);
  return error ? kDefaultBytes : std::min<uint64_t>(kDefaultBytes, disk.capacity / 10);
}

std::optional<Action> action_of(const fs::path& folder, const std::string& key) {
  const auto text = read_sealed(file_of(folder, kActions, key));
  const auto action = text ? parse_action(*text) : std::nullopt;
  return action && action->key == key ? action : std::nullopt;
}

void touch(const fs::path& file) {
  std::error_code ignored;  // A folder that is not writable is not trimmed either.
  fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
}

std::string to_text(const Key& key) {
  std::string out;
  for (const Key::Part& part : key.parts())
    out += fmt::format("{} {:x} {:x}\n", part.name, part.digest.high, part.digest.low);
  return out;
}

std::vector<Key::Part> parse_parts(const std::string& text) {
  std::istringstream in(text);
  std::vector<Key::Part> out;
  Key::Part part;
  while (in >> part.name >> std::hex >> part.digest.high >> part.digest.low) out.push_back(part);
  return out;
}

}  // namespace

Store::Store(StoreOptions options) : options_(std::move(options)) {
  std::error_code error;
  fs::create_directories(options_.folder / kObjects, error);
  writable_ = !error && access(options_.folder.c_str(), W_OK) == 0;
  if (options_.max_bytes == 0) options_.max_bytes = limit_for(options_.folder);
  if (!options_.remote.empty())
    remote_ = std::make_unique<Remote>(options_.remote, options_.on_warning);
}

Store::~Store() = default;

void Store::warn(const std::string& why) {
  if (options_.on_warning && !warned_.exchange(true)) options_.on_warning(why);
}

bool Store::contains(const Key& key) const {
  std::error_code ignored;
  const auto action = action_of(folder(), key.digest().hex());
  if (action && fs::exists(file_of(folder(), kObjects, action->object), ignored)) return true;
  return remote_ && writable_ && remote_->has(name_of(kActions, key.digest().hex()));
}

std::optional<Entry> Store::find(const Key& key) {
  std::optional<Entry> out = find_here(key);
  return out ? out : fetch(key);
}

std::optional<Entry> Store::find_here(const Key& key) {
  std::error_code ignored;
  const fs::path file = file_of(folder(), kActions, key.digest().hex());
  if (!fs::exists(file, ignored)) return std::nullopt;
  const auto action = action_of(folder(), key.digest().hex());
  if (!action) return discard(file), std::nullopt;
  const fs::path object = file_of(folder(), kObjects, action->object);
  if (!is_intact(object, object.stem())) {
    discard(object), discard(file);
    return std::nullopt;
  }
  touch(object), touch(file);
  return Entry{object, action->seconds};
}

/// Copies a product from the server.
std::optional<Entry> Store::fetch(const Key& key) {
  if (!remote_ || !writable_) return std::nullopt;
  const std::string hex = key.digest().hex();
  const fs::path action_file = temporary_file(folder(), "");
  const auto fetched_action = [&]() -> std::optional<Action> {
    if (!remote_->get(name_of(kActions, hex), action_file)) return std::nullopt;
    const auto text = read_sealed(action_file);
    const auto action = text ? parse_action(*text) : std::nullopt;
    return action && action->key == hex && is_object_name(action->object) ? action : std::nullopt;
  };
  const auto fetch_object = [&](const std::string& name, const fs::path& target) {
    if (is_intact(target, target.stem())) return touch(target), true;
    const fs::path temporary = temporary_file(folder(), target.extension());
    const bool found = remote_->get(name_of(kObjects, name), temporary);
    if (!found || !is_intact(temporary, target.stem())) return discard(temporary), false;
    if (!move_into_place(temporary, target).empty()) return false;
    trim_shard(folder(), name, max_bytes());
    return true;
  };
  if (const auto action = fetched_action()) {
    const fs::path object = file_of(folder(), kObjects, action->object);
    if (fetch_object(action->object, object) &&
        move_into_place(action_file, file_of(folder(), kActions, hex)).empty())
      return Entry{object, action->seconds};
  }
  discard(action_file);
  return std::nullopt;
}

/// Copies a product to the server; the object first, so that no action lacks it.
void Store::send(const std::string& key, const std::string& object) {
  if (!remote_) return;
  if (!remote_->has(name_of(kObjects, object)))
    remote_->put(name_of(kObjects, object), file_of(folder(), kObjects, object));
  remote_->put(name_of(kActions, key), file_of(folder(), kActions, key));
}

void Store::keep(const Key& key, double seconds, const std::string& extension,
                 const std::function<void(const fs::path&)>& write) {
  if (!writable_) return;
  const fs::path temporary = temporary_file(folder(), extension);
  try {
    write(temporary);
    const auto content = digest_of_file(temporary);
    if (!content) return discard(temporary), warn("a product cannot be read again");
    const std::string hex = key.digest().hex();
    const Action action{hex, key.kind(), content->hex() + extension, fs::file_size(temporary),
                        seconds};
    const std::string fault =
        move_into_place(temporary, file_of(folder(), kObjects, action.object));
    if (!fault.empty()) return warn(fault);
    trim_shard(folder(), action.object, max_bytes());
    if (!write_sealed(folder(), file_of(folder(), kActions, hex), store::to_text(action)))
      return warn("the disk is full");
    send(hex, action.object);
  } catch (const std::exception& error) {
    discard(temporary);
    warn(error.what());
  }
}

std::optional<std::vector<Key::Part>> Store::recall(const std::string& name, const Key& key) const {
  const auto text = read_sealed(file_of(folder(), kNames, digest_of(key.kind(), name).hex()));
  return text ? std::optional(parse_parts(*text)) : std::nullopt;
}

std::optional<std::vector<Key::Part>> Store::remember(const std::string& name, const Key& key) {
  auto before = recall(name, key);
  if (writable_ && before != key.parts())
    write_sealed(folder(), file_of(folder(), kNames, digest_of(key.kind(), name).hex()),
                 to_text(key));
  return before;
}

}  // namespace vug::store
