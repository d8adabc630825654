// SPDX-License-Identifier: Apache-2.0
#include <vug/base/xml.h>
#include <vug/image/page.h>

namespace vug::image {
namespace {

// Neutral greys around an image, because adjacent colours would change its appearance.
constexpr const char* kStyle = R"(
:root { color-scheme: dark; }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 1280px; padding: 28px 24px 60px; background: #1b1b1b; color: #d6d6d6;
       font: 15px/1.5 system-ui, sans-serif; }
header { display: flex; align-items: center; gap: 14px; }
h1 { font-size: 22px; font-weight: 600; margin: 0; color: #f2f2f2; overflow-wrap: anywhere; }
h2 { font-size: 13px; font-weight: 600; margin: 0 0 8px; color: #9c9c9c; text-transform: uppercase;
     letter-spacing: .08em; }
code { font: 13px ui-monospace, monospace; color: #c9c9c9; overflow-wrap: anywhere; }
a { color: #e6b36a; }
.verdict { padding: 3px 12px; border-radius: 99px; font-weight: 600; font-size: 13px; color: #141414;
           background: #9a9a9a; }
.verdict.same { background: #7fbf8a; } .verdict.different { background: #f08a4b; }
.verdict.unusable { background: #d8c25a; } .verdict.flaky { background: #b59be0; }
.why { margin: 10px 0 2px; color: #f2f2f2; } .files { margin: 0 0 16px; color: #8f8f8f; font-size: 13px; }
.controls { display: flex; flex-wrap: wrap; align-items: center; gap: 6px; margin-bottom: 10px; }
.controls button { font: inherit; font-size: 13px; padding: 5px 13px; border: 1px solid #3a3a3a;
  border-radius: 7px; background: #262626; color: #d6d6d6; cursor: pointer; }
.controls button[aria-pressed=true] { background: #d6d6d6; color: #161616; border-color: #d6d6d6; }
.controls input { flex: 1; min-width: 140px; max-width: 420px; accent-color: #e6b36a; margin-left: 8px; }
.controls kbd { font: 12px ui-monospace, monospace; color: #8f8f8f; margin-left: auto; }
.stage { --cut: 50%; position: relative; background: #101010; border-radius: 8px; overflow: hidden; }
figure { margin: 0; } figure img { display: block; width: 100%; }
img.small { image-rendering: pixelated; }
figcaption { position: absolute; top: 10px; left: 10px; padding: 1px 9px; border-radius: 6px;
             background: #000a; font-size: 12px; }
figure + figure { position: absolute; inset: 0; }
#test figcaption { left: auto; right: 10px; }
.stage[data-mode=slide] #test { clip-path: inset(0 0 0 var(--cut)); }
.stage[data-mode=reference] figure + figure, .stage[data-mode=slide] #heat,
.stage[data-mode=slide] #blocks, .stage[data-mode=test] #heat, .stage[data-mode=test] #blocks,
.stage[data-mode=heat] #blocks { display: none; }
.bar { display: none; position: absolute; top: 0; bottom: 0; left: var(--cut); width: 1px; background: #fffc; }
.stage[data-mode=slide] .bar { display: block; }
.columns { display: flex; flex-wrap: wrap; gap: 20px 44px; margin-top: 26px; }
section { flex: 1; min-width: 330px; } section p { margin: 8px 0 10px; font-size: 13.5px; color: #a8a8a8; }
table { border-collapse: collapse; width: 100%; font-size: 13.5px; }
th { text-align: left; font-weight: 500; color: #8f8f8f; padding: 3px 10px 3px 0; }
td { padding: 2px 10px 2px 0; } tr.first td { border-top: 1px solid #303030; padding-top: 5px; }
.n { font-variant-numeric: tabular-nums; } .ok { color: #7fbf8a; } .no { color: #f08a4b; }
)";

constexpr const char* kScript = R"(<script>
const stage = document.getElementById('stage'), slider = document.getElementById('cut');
const buttons = [...document.querySelectorAll('.controls button')];
const mode = name => { stage.dataset.mode = name;
  buttons.forEach(b => b.setAttribute('aria-pressed', b.dataset.mode === name));
  slider.style.visibility = name === 'slide' ? 'visible' : 'hidden'; };
const cut = share => { slider.value = share; stage.style.setProperty('--cut', share + '%'); };
buttons.forEach(b => b.addEventListener('click', () => mode(b.dataset.mode)));
slider.addEventListener('input', () => cut(slider.value));
stage.addEventListener('pointermove', e => { if (stage.dataset.mode !== 'slide') return;
  const box = stage.getBoundingClientRect(); cut(100 * (e.clientX - box.left) / box.width); });
document.addEventListener('keydown', e => { if (e.key !== ' ') return; e.preventDefault();
  mode(stage.dataset.mode === 'reference' ? 'test' : 'reference'); });
mode('slide');
</script>
)";

}  // namespace

std::string page_head(const std::string& title) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
         "<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
         xml_text(title) + "</title>\n<style>" + kStyle + "</style></head>\n<body>\n";
}

std::string page_foot() { return "</body></html>\n"; }

std::string page_controls(bool blocks) {
  std::string out =
      "<div class=\"controls\"><button data-mode=\"slide\">slider</button>"
      "<button data-mode=\"reference\">reference</button><button data-mode=\"test\">test</button>"
      "<button data-mode=\"heat\">heat map</button>";
  if (blocks) out += "<button data-mode=\"blocks\">z-scores</button>";
  return out +
         "<input id=\"cut\" type=\"range\" min=\"0\" max=\"100\" step=\"0.1\" value=\"50\" "
         "aria-label=\"where the test begins\"><kbd>space: flip</kbd></div>\n";
}

std::string page_script() { return kScript; }

}  // namespace vug::image
