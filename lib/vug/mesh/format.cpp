// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/mesh/file.h>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace vug::mesh {

const Format& format_of(const std::filesystem::path& file) {
  std::string extension = extension_of(file);
  if (!extension.empty()) extension.erase(0, 1);
  std::vector<std::string> known;
  for (const Format* format : formats()) {
    if (format->info.name == extension) return *format;
    known.push_back(format->info.name);
  }
  throw Error(ErrorCode::bad_input,
              fmt::format("'{}' does not have the extension of a mesh format", file.string()), {},
              fmt::format("known: {}", fmt::join(known, ", ")));
}

Mesh read_mesh(const std::filesystem::path& file) {
  const Format& format = format_of(file);
  Mesh mesh = format.read(read_text(file), file.string());
  validate(mesh, file.string());
  return mesh;
}

void write_file(const std::filesystem::path& file,
                const std::function<void(const ByteSink&)>& write) {
  write_file_with_header(file, [&](const ByteSink& sink) {
    write(sink);
    return std::string();
  });
}

void write_file_with_header(const std::filesystem::path& file,
                            const std::function<std::string(const ByteSink&)>& write) {
  AtomicFile target(file);
  const auto refuse = [&] {
    throw Error(ErrorCode::io,
                fmt::format("cannot write '{}': {}", file.string(), std::strerror(errno)));
  };
  struct Closer {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };
  std::unique_ptr<std::FILE, Closer> out(std::fopen(target.path().c_str(), "wb"));
  if (!out) refuse();
  const auto put = [&](std::string_view bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), out.get()) != bytes.size()) refuse();
  };
  const std::string header = write(put);
  if (!header.empty()) {
    if (std::fseek(out.get(), 0, SEEK_SET) != 0) refuse();
    put(header);
  }
  if (std::fclose(out.release()) != 0) refuse();
  target.commit();
}

void write_mesh(const Mesh& mesh, const std::filesystem::path& file, const Comments& notes) {
  const Format& format = format_of(file);
  validate(mesh, file.string());
  write_file(file, [&](const ByteSink& sink) { format.write(mesh, notes, sink); });
}

}  // namespace vug::mesh
