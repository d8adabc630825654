// SPDX-License-Identifier: Apache-2.0
// The report of a comparison of pictures as an HTML page.
#include <vug/base/srgb.h>
#include <vug/base/xml.h>
#include <vug/image/page.h>
#include <vug/image/report.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace vug::image {
namespace {

/// Narrower images are enlarged, pixel by pixel.
constexpr int kSmall = 640;

std::string base64(const std::string& bytes) {
  constexpr const char* kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t three = 0;
    for (size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0u);
    for (size_t k = 0; k < 4; ++k)
      out += i + k <= bytes.size() ? kDigits[three >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

/// Signed z-scores: blue where the test is darker, orange where it is brighter, grey where they are
/// equal.
Image z_picture(const std::vector<float>& z, int width, int height) {
  constexpr double kFull = 6, kGrey = 0.17;
  constexpr double kDarker[] = {0.25, 0.55, 1.0}, kBrighter[] = {1.0, 0.6, 0.15};
  Image out(width, height, {"R", "G", "B"});
  for (size_t p = 0; p < z.size(); ++p) {
    const double t = std::min(std::fabs(static_cast<double>(z[p])) / kFull, 1.0);
    for (size_t c = 0; c < 3; ++c)
      out.pixels[3 * p + c] = static_cast<float>(
          srgb_decode(kGrey + t * ((z[p] < 0 ? kDarker[c] : kBrighter[c]) - kGrey)));
  }
  return out;
}

std::string picture(const std::string& id, const std::string& label, const Image& image,
                    const ViewOptions& view, const std::string& scale = {}) {
  return fmt::format(
      "<figure id=\"{}\"><img{} alt=\"{}\" src=\"data:image/png;base64,{}\"><figcaption>{}{}"
      "</figcaption></figure>\n",
      id, image.width < kSmall ? " class=\"small\"" : "", label, base64(png_bytes(image, view)),
      label, scale);
}

/// A layer without colours is shown from its minimum to its maximum.
Image as_grey(const Image& layer, double low, double high) {
  Image out(layer.width, layer.height, {"Y"});
  for (size_t p = 0; p < out.pixels.size(); ++p) {
    const double v = static_cast<double>(layer.pixels[p * layer.channels.size()]);
    out.pixels[p] =
        static_cast<float>(high > low && std::isfinite(v) ? (v - low) / (high - low) : 0);
  }
  return out;
}

void add_pictures(const Diff& diff, std::string& out) {
  Image a = diff.shown.reference, b = diff.shown.test;
  const ViewOptions plain = plain_view();
  ViewOptions view = diff.shown.view;
  if (diff.heat_measure != "flip") {
    double low = kInfinity, high = -kInfinity;
    for (const Image* image : {&a, &b})
      for (size_t i = 0; i < image->pixels.size(); i += image->channels.size()) {
        const auto v = static_cast<double>(image->pixels[i]);
        if (std::isfinite(v) && std::fabs(v) < 1e9)
          low = std::min(low, v), high = std::max(high, v);
      }
    a = as_grey(a, low, high), b = as_grey(b, low, high);
    view = plain;
  }
  out += "<div class=\"stage\" id=\"stage\" data-mode=\"slide\">\n";
  out += picture("reference", "reference", a, view) + picture("test", "test", b, view);
  out += picture("heat", "heat map (" + diff.heat_measure + ")", heat_picture(diff), plain,
                 diff.heat_measure == "flip" ? ", from 0 to 1" : ", from 0 to the largest");
  if (diff.significance)
    out +=
        picture("blocks", "z-scores of blocks", z_picture(diff.significance->z, a.width, a.height),
                plain, ": blue where the test is darker, orange where brighter");
  out += "<div class=\"bar\"></div></div>\n";
}

std::string limit_cell(const LayerResult& row) {
  if (!row.limit) return "<td></td>";
  const bool low = measure_of(row.measure).better == Measure::Better::low;
  return fmt::format("<td class=\"{}\">{} {:.6g}</td>", row.passed ? "ok" : "no",
                     low ? "at most" : "at least", *row.limit);
}

void add_measures(const Diff& diff, std::string& out) {
  out +=
      "<section><h2>Measures</h2><table><tr><th>layer</th><th>measure</th><th>value</th>"
      "<th>limit</th></tr>\n";
  std::string layer;
  for (const LayerResult& row : diff.rows) {
    out += fmt::format(
        "<tr{}><td>{}</td><td title=\"{}\">{}</td><td class=\"n\">{:.6g}</td>{}</tr>\n",
        row.layer != layer ? " class=\"first\"" : "", row.layer != layer ? xml_text(row.layer) : "",
        xml_text(measure_of(row.measure).info.doc), row.measure, row.value, limit_cell(row));
    layer = row.layer;
  }
  out += "</table>";
  if (!diff.identical.empty())
    out += fmt::format("<p>Identical: {}.</p>",
                       xml_text(fmt::format("{}", fmt::join(diff.identical, ", "))));
  if (!diff.reasons.empty()) {
    out += "<h2>Reasons</h2><ul>";
    for (const std::string& reason : diff.reasons)
      out += fmt::format("<li>{}</li>", xml_text(reason));
    out += "</ul>";
  }
  out += "</section>\n";
}

void add_significance(const Significance& s, const std::string& of, bool heeded, std::string& out) {
  out += fmt::format(
      "<section><h2>Significance{}</h2><p>{} blocks of {} × {} pixels: mean z {:.3f}, standard "
      "deviation {:.3f}, |z| > 3 in {:.2f} % (noise: 0.27 %), brightness {:+.3f} %.{}</p>\n"
      "<table><tr><th>finding</th><th>channel</th><th>value</th><th>chance by noise</th></tr>\n",
      of, s.blocks, s.block, s.block, s.mean_z, s.std_z, 100 * s.beyond_3, 100 * s.bias,
      heeded ? "" : " The verdict is based on limits instead.");
  for (const Finding& f : s.findings)
    out += fmt::format(
        "<tr class=\"first\"><td>{}</td><td>{}</td><td class=\"n\">{:.4g}</td>"
        "<td class=\"{}\">{:.3g}</td></tr>\n",
        f.name, f.channel, f.value, f.different ? "no" : "ok", f.p_value);
  out += "</table></section>\n";
}

}  // namespace

std::string to_html(const Diff& diff, const std::string& title, const std::string& reference,
                    const std::string& test) {
  std::string out = page_head(title);
  out += fmt::format("<header><span class=\"verdict {}\">{}</span><h1>{}</h1></header>\n",
                     diff.same ? "same" : "different", diff.same ? "same" : "different",
                     xml_text(title));
  out += fmt::format("<p class=\"why\">{}</p>\n", xml_text(verdict_text(diff)));
  for (const std::string& remark : remarks(diff))
    out += fmt::format("<p class=\"files\">{}</p>\n", xml_text(remark));
  out += fmt::format(
      "<p class=\"files\">reference <code>{}</code> · test <code>{}</code> · layer "
      "<code>{}</code> · exposure {:+.2f}</p>\n",
      xml_text(reference), xml_text(test), xml_text(diff.shown_layer), diff.exposure);
  out += page_controls(diff.significance.has_value());
  add_pictures(diff, out);
  out += "<div class=\"columns\">\n";
  add_measures(diff, out);
  if (diff.significance) add_significance(*diff.significance, "", diff.tested, out);
  for (const auto& [view, significance] : diff.other_views)
    add_significance(significance, " of " + xml_text(view), diff.tested, out);
  out += "</div>\n";
  return out + page_script() + page_foot();
}

}  // namespace vug::image
