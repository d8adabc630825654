// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ: text, with indices from 1, or negative ones relative to the newest.
#include <vug/mesh/byte_writer.h>
#include <vug/mesh/format_kind.h>
#include <vug/mesh/polygon.h>
#include <vug/mesh/text_scanner.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::mesh {
namespace {

constexpr std::string_view kIgnored[] = {
    "vt",   "vp",    "o",     "g",     "s",        "l",        "p",      "mtllib",     "usemtl",
    "mg",   "bevel", "lod",   "curv",  "curv2",    "deg",      "surf",   "parm",       "trim",
    "hole", "scrv",  "sp",    "end",   "con",      "bmat",     "step",   "cstype",     "maplib",
    "call", "csh",   "ctech", "stech", "c_interp", "d_interp", "usemap", "shadow_obj", "trace_obj"};

constexpr uint32_t kNoNormal = UINT32_MAX;
constexpr uint32_t kMany = UINT32_MAX - 1;

struct Reader {
  TextScanner scan;
  Mesh mesh;
  std::vector<float> colours;  ///< Colours of the vertices so far; empty or three each.
  std::vector<Vec3f> normals;
  std::vector<uint32_t>
      normal_of;  ///< Per vertex: the one normal that its corners refer to, or none, many.
  std::vector<uint32_t> polygon;

  std::vector<double> numbers() {
    std::vector<double> list;
    for (std::string_view w = scan.word_in_line(); !w.empty() && w.front() != '#';
         w = scan.word_in_line()) {
      if (list.size() == 8) scan.fail("too many numbers on this line");
      list.push_back(scan.number(w));
    }
    return list;
  }

  static Vec3f narrow(const TextScanner& scan, double x, double y, double z) {
    constexpr double kLimit = std::numeric_limits<float>::max();
    if (std::max({x, y, z}) > kLimit || std::min({x, y, z}) < -kLimit)
      scan.fail("a number is too large for single precision");
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
  }

  void vertex() {
    const std::vector<double> n = numbers();
    // x y z, x y z w, x y z r g b; w is relevant to free-form surfaces only.
    if (n.size() != 3 && n.size() != 4 && n.size() != 6 && n.size() != 7)
      scan.fail(fmt::format("a vertex has 3 coordinates, not {}", n.size()),
                "v x y z, or v x y z red green blue");
    mesh.positions.push_back(narrow(scan, n[0], n[1], n[2]));
    if (n.size() >= 6) {
      colours.resize(3 * (mesh.positions.size() - 1), 1.0F);
      const Vec3f c = narrow(scan, n[n.size() - 3], n[n.size() - 2], n[n.size() - 1]);
      colours.insert(colours.end(), {c.x, c.y, c.z});
    }
  }

  void normal() {
    const std::vector<double> n = numbers();
    if (n.size() != 3) scan.fail(fmt::format("a normal has 3 coordinates, not {}", n.size()));
    normals.push_back(narrow(scan, n[0], n[1], n[2]));
  }

  uint32_t index(std::string_view word, size_t count, const char* what) const {
    const int64_t given = scan.integer(word);
    const auto total = static_cast<int64_t>(count);
    const int64_t from_0 = given < 0 ? total + given : given - 1;
    if (given == 0 || from_0 < 0 || from_0 >= total)
      scan.fail(fmt::format("unknown {} {}: there are {} so far", what, given, count),
                given == 0 ? "indices count from 1" : "");
    return static_cast<uint32_t>(from_0);
  }

  void corner(std::string_view word) {
    const size_t first = std::min(word.find('/'), word.size());
    const uint32_t v = index(word.substr(0, first), mesh.positions.size(), "vertex");
    polygon.push_back(v);
    const size_t second = word.find('/', std::min(first + 1, word.size()));
    if (second == std::string_view::npos || second + 1 == word.size()) return;
    const uint32_t n = index(word.substr(second + 1), normals.size(), "normal");
    normal_of.resize(mesh.positions.size(), kNoNormal);
    if (normal_of[v] == kNoNormal)
      normal_of[v] = n;
    else if (normal_of[v] != kMany && normals[normal_of[v]] != normals[n])
      normal_of[v] = kMany;
  }

  void face() {
    polygon.clear();
    for (std::string_view w = scan.word_in_line(); !w.empty() && w.front() != '#';
         w = scan.word_in_line()) {
      if (w == "\\") {  // The statement continues on the next line.
        scan.next_line();
        continue;
      }
      corner(w);
    }
    if (polygon.size() < 3)
      scan.fail(fmt::format("a face has at least 3 corners, not {}", polygon.size()));
    add_polygon(mesh, polygon);
  }

  void statement(std::string_view keyword) {
    if (keyword == "v") return vertex();
    if (keyword == "vn") return normal();
    if (keyword == "f" || keyword == "fo") return face();
    if (std::find(std::begin(kIgnored), std::end(kIgnored), keyword) == std::end(kIgnored))
      scan.fail(fmt::format("unknown OBJ statement '{}'", mesh::printable(keyword)),
                "is this an OBJ file?");
  }

  Mesh finish() {
    if (mesh.positions.empty()) scan.fail("the file contains no vertex", "is this an OBJ file?");
    if (!colours.empty()) {
      colours.resize(3 * mesh.positions.size(), 1.0F);
      mesh.attributes.push_back({std::string(kColour), 3, std::move(colours)});
    }
    normal_of.resize(mesh.positions.size(), kNoNormal);
    if (std::all_of(normal_of.begin(), normal_of.end(), [](uint32_t n) { return n < kMany; })) {
      for (const uint32_t n : normal_of) mesh.normals.push_back(normals[n]);
    }
    return std::move(mesh);
  }
};

Mesh read_obj(std::string_view bytes, const std::string& file) {
  Reader reader{TextScanner(bytes, file), {}, {}, {}, {}, {}};
  do {
    const std::string_view keyword = reader.scan.word_in_line();
    if (!keyword.empty() && keyword.front() != '#') reader.statement(keyword);
  } while (reader.scan.next_line());
  return reader.finish();
}

void write_obj(const Mesh& mesh, const Comments& notes, const ByteSink& sink) {
  ByteWriter out(sink);
  out.text(comment_lines(notes, "# "));
  const Attribute* colour = find_attribute(mesh, kColour, 3);
  const auto triple = [&](const auto& v) {
    out.text(" ").number(v[0]).text(" ").number(v[1]).text(" ").number(v[2]);
  };
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    out.text("v");
    triple(mesh.positions[i]);
    if (colour) triple(colour->values.data() + 3 * i);
    out.text("\n");
  }
  for (const Vec3f& n : mesh.normals) {
    out.text("vn");
    triple(n);
    out.text("\n");
  }
  for (const Triangle& t : mesh.triangles) {
    out.text("f");
    for (const uint32_t corner : t) {
      out.text(" ").number(uint64_t{corner} + 1);
      if (!mesh.normals.empty()) out.text("//").number(uint64_t{corner} + 1);
    }
    out.text("\n");
  }
  out.finish();
}

}  // namespace
}  // namespace vug::mesh

VUG_MESH_FORMAT(obj) {
  return mesh_format(
      "obj",
      "Wavefront text: positions, vertex colours, and normals if each vertex has one. Texture "
      "coordinates, groups and materials are ignored on reading; other attributes are not written",
      "wavefront1995", read_obj, write_obj);
}
