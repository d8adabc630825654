// SPDX-License-Identifier: Apache-2.0
#include <vug/store/layout.h>

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <fstream>
#include <sstream>
#include <system_error>
#include <vector>

namespace vug::store {

namespace fs = std::filesystem;

std::string name_of(const char* files, const std::string& hex) {
  return fmt::format("{}/{}/{}", files, hex.substr(0, 2), hex);
}

fs::path file_of(const fs::path& folder, const char* files, const std::string& hex) {
  return folder / name_of(files, hex);
}

std::optional<Digest> digest_of_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  Hasher hasher;
  std::vector<char> part(1 << 20);
  while (in.read(part.data(), static_cast<std::streamsize>(part.size())) || in.gcount() > 0)
    hasher.add(part.data(), static_cast<size_t>(in.gcount()));
  return in.bad() ? std::nullopt : std::optional(hasher.finish());
}

bool is_intact(const fs::path& file, const std::string& hex) {
  const auto content = digest_of_file(file);
  return content && content->hex() == hex;
}

std::optional<std::string> read_sealed(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  std::ostringstream text;
  text << in.rdbuf();
  std::string all = text.str();
  constexpr size_t kSeal = 33;  // A digest and a line end.
  if (all.size() < kSeal) return std::nullopt;
  const std::string seal = all.substr(all.size() - kSeal);
  all.resize(all.size() - kSeal);
  return seal == digest(all).hex() + "\n" ? std::optional(all) : std::nullopt;
}

bool write_sealed(const fs::path& store, const fs::path& file, const std::string& text) {
  const fs::path temporary = temporary_file(store, "");
  {
    std::ofstream out(temporary, std::ios::binary);
    out << text << digest(text).hex() << "\n";
    if (!out.flush()) {
      discard(temporary);
      return false;
    }
  }
  return move_into_place(temporary, file).empty();
}

bool discard(const fs::path& file) {
  std::error_code error;
  return fs::remove(file, error) && !error;
}

fs::path temporary_file(const fs::path& store, const std::string& extension) {
  static std::atomic<uint64_t> number = 0;
  std::error_code ignored;
  fs::create_directories(store / kTemporary, ignored);
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);  // Machines may share the folder.
  return store / kTemporary / fmt::format("{}.{}.{}{}", host.data(), getpid(), number++, extension);
}

std::string move_into_place(const fs::path& temporary, const fs::path& target) {
  std::error_code error;
  fs::create_directories(target.parent_path(), error);
  if (!error) fs::rename(temporary, target, error);
  if (!error) return "";
  discard(temporary);
  return error.message();
}

bool is_object_name(const std::string& text) {
  constexpr size_t kDigits = 32;
  const std::string digits = text.substr(0, kDigits), extension = text.substr(digits.size());
  return digits.size() == kDigits &&
         digits.find_first_not_of("0123456789abcdef") == std::string::npos &&
         extension.starts_with('.') &&
         std::all_of(extension.begin() + 1, extension.end(),
                     [](unsigned char c) { return std::isalnum(c); });
}

std::string to_text(const Action& action) {
  return fmt::format("vug action 1\n{} {} {} {} {}\n", action.key, action.kind, action.object,
                     action.bytes, action.seconds);
}

std::optional<Action> parse_action(const std::string& text) {
  std::istringstream in(text);
  std::string line;
  Action action;
  if (!std::getline(in, line) || line != "vug action 1") return std::nullopt;
  if (!(in >> action.key >> action.kind >> action.object >> action.bytes >> action.seconds))
    return std::nullopt;
  return action.object.size() > 2 ? std::optional(action) : std::nullopt;
}

}  // namespace vug::store
