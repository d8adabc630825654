// SPDX-License-Identifier: Apache-2.0
#include <vug/base/hash.h>
#include <vug/exchange/usd_variants.h>
#include <vug/exchange/usda_writer.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace vug::exchange {
namespace {

/// Where a pass writes.
struct Target {
  std::filesystem::path file;            ///< Environment maps are named after this file.
  const mesh::ByteSink* sink = nullptr;  ///< Null: nothing is written.
  size_t depth = 0;                      ///< Number of blocks around the parts.
};

/// A pass over the parts of an assembly, of which some are written.
class UsdaPass {
 public:
  UsdaPass(const Assembly& assembly, const FormatOptions& options, const Target& target)
      : sink_([this, target](std::string_view bytes) {
          digest_.add(bytes);
          if (target.sink && writes_) (*target.sink)(bytes);
        }),
        text_(sink_, target.depth),
        writer_(assembly, options, text_, target.file, report_) {}

  /// The digests of all parts; `keeps` selects the parts to write by their index.
  std::vector<std::string> run(const std::function<bool(size_t)>& keeps, Progress& progress) {
    std::vector<std::string> digests;
    writer_.each_part(
        [&](const UsdaWriter::Part& write) {
          digest_ = Hasher();
          writes_ = keeps(digests.size());
          writer_.write_skies(writes_);
          write();
          text_.finish();
          digests.push_back(digest_.finish().hex());
        },
        progress);
    return digests;
  }
  const WriteReport& report() const { return report_; }

 private:
  Hasher digest_;
  bool writes_ = false;
  mesh::ByteSink sink_;
  WriteReport report_;
  UsdText text_;
  UsdaWriter writer_;
};

/// Writes the assembly and its variants as variants of the root prim. Parts that are equal in all
/// of them are outside of the variants.
class UsdaVariants {
 public:
  UsdaVariants(const Assembly& assembly, const std::filesystem::path& file,
               const FormatOptions& options, Progress& progress)
      : options_(options), progress_(progress) {
    UniqueNames names;
    for (const AssemblyVariant& each : options.variants)
      versions_.push_back({names.unique(each.name), each.assembly.get(), picture_file(file, each)});
    versions_.insert(versions_.begin(), Version{names.unique("default"), &assembly, file});
    for (Version& each : versions_) {
      each.digests = UsdaPass(*each.assembly, options_, {each.file})
                         .run([](size_t) { return false; }, progress_);
      for (const std::string& part : std::set(each.digests.begin(), each.digests.end()))
        ++occurrences_[part];
    }
  }

  void write(const mesh::ByteSink& sink, WriteReport& written) {
    const Version& whole = versions_.front();
    UsdText text(sink);
    UsdaWriter root(*whole.assembly, options_, text, whole.file, written);
    root.begin({"prepend variantSets = \"variant\"",
                fmt::format("variants = {{ string variant = \"{}\" }}", whole.name)});
    text.finish();
    write_parts(whole, true, sink, written);
    text.open("variantSet \"variant\" = {");
    for (const Version& each : versions_) {
      text.open(fmt::format("\"{}\" {{", each.name)).finish();
      write_parts(each, false, sink, written);
      text.end();
    }
    text.end();
    root.end();
  }

 private:
  struct Version {
    std::string name;
    const Assembly* assembly;
    std::filesystem::path file;  ///< Its environment maps are named after this file.
    std::vector<std::string> digests = {};
  };

  static std::filesystem::path picture_file(const std::filesystem::path& file,
                                            const AssemblyVariant& variant) {
    return file.parent_path() /
           fmt::format("{}_{}{}", file.stem().string(), variant.name, file.extension().string());
  }

  /// Writes the parts that all versions share, or the others.
  void write_parts(const Version& version, bool shared, const mesh::ByteSink& sink,
                   WriteReport& written) {
    UsdaPass pass(*version.assembly, options_, {version.file, &sink, shared ? 1u : 3u});
    pass.run(
        [&](size_t part) {
          return (occurrences_.at(version.digests[part]) == versions_.size()) == shared;
        },
        progress_);
    const auto add = [](const auto& from, auto& to) {
      for (const auto& each : from)
        if (std::find(to.begin(), to.end(), each) == to.end()) to.push_back(each);
    };
    add(pass.report().files, written.files);
    add(pass.report().unsupported, written.unsupported);
  }

  const FormatOptions& options_;
  Progress& progress_;
  std::vector<Version> versions_;
  std::map<std::string, size_t> occurrences_;
};

}  // namespace

void write_usd_variants(const Assembly& assembly, const std::filesystem::path& file,
                        const FormatOptions& options, const mesh::ByteSink& sink,
                        WriteReport& written, Progress& progress) {
  UsdaVariants(assembly, file, options, progress).write(sink, written);
}

}  // namespace vug::exchange
