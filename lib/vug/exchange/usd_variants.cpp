// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/usd_digest.h>
#include <vug/exchange/usd_variants.h>
#include <vug/exchange/usd_writer.h>

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace vug::exchange {
namespace {

/// A pass over the parts of an assembly, of which some are written.
class UsdPass {
 public:
  /// Environment maps are named after `file`.
  UsdPass(const Assembly& assembly, const FormatOptions& options, const std::filesystem::path& file)
      : writer_(assembly, options, digest_, file, report_) {}

  /// The digests of all parts.
  std::vector<std::string> digests(Progress& progress) {
    std::vector<std::string> all;
    writer_.write_skies(false);
    writer_.each_part(
        [&](const UsdWriter::Part& write) {
          write();
          all.push_back(digest_.take().hex());
        },
        progress);
    return all;
  }
  /// Writes the parts whose index `keeps` selects.
  void write(UsdLayer& layer, const std::function<bool(size_t)>& keeps, Progress& progress) {
    size_t part = 0;
    writer_.each_part(
        [&](const UsdWriter::Part& write) {
          const bool kept = keeps(part++);
          writer_.write_skies(kept);
          writer_.write_into(kept ? layer : digest_);
          write();
        },
        progress);
  }
  const WriteReport& report() const { return report_; }

 private:
  UsdDigest digest_;
  WriteReport report_;
  UsdWriter writer_;
};

/// Writes the assembly and its variants as variants of the root prim. Parts that are equal in all
/// of them are outside of the variants.
class UsdVariants {
 public:
  UsdVariants(const Assembly& assembly, const std::filesystem::path& file,
              const FormatOptions& options, Progress& progress)
      : options_(options), progress_(progress) {
    UniqueNames names;
    for (const AssemblyVariant& each : options.variants)
      versions_.push_back({names.unique(each.name), each.assembly.get(), picture_file(file, each)});
    versions_.insert(versions_.begin(), Version{names.unique("default"), &assembly, file});
    for (Version& each : versions_) {
      each.digests = UsdPass(*each.assembly, options_, each.file).digests(progress_);
      for (const std::string& part : std::set(each.digests.begin(), each.digests.end()))
        ++occurrences_[part];
    }
  }

  void write(UsdLayer& layer, WriteReport& written) {
    const Version& whole = versions_.front();
    UsdWriter root(*whole.assembly, options_, layer, whole.file, written);
    root.begin({usd_variant_set("variant"), usd_variant_selection("variant", whole.name)});
    write_parts(whole, true, layer, written);
    layer.begin_variant_set("variant");
    for (const Version& each : versions_) {
      layer.begin_variant(each.name);
      write_parts(each, false, layer, written);
      layer.end();
    }
    layer.end();
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
  void write_parts(const Version& version, bool shared, UsdLayer& layer, WriteReport& written) {
    UsdPass pass(*version.assembly, options_, version.file);
    pass.write(
        layer,
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
                        const FormatOptions& options, UsdLayer& layer, WriteReport& written,
                        Progress& progress) {
  UsdVariants(assembly, file, options, progress).write(layer, written);
}

}  // namespace vug::exchange
