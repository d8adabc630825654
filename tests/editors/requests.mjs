// SPDX-License-Identifier: Apache-2.0
// The golden requests: a method, a text whose "|" is the position, and further parameters.
const scene = `param voxel = 4cm in 1cm..50cm "edge of a voxel"
let radius = 10 * voxel
# A ball with a hole.
def ball(size, hole = 0.2 * size) "A hollow ball." = difference(sphere(size), [sphere(hole)])
volume rock = level_set(ball(radius), voxel: voxel)
mesh skin on rock { paint (0.5, 0.2, 0.1) }
object body on skin { material lambert(albedo: (0.5, 0.4, 0.3)) }
camera main { eye (0, 1, 4)  target (0, 0, 0) }
light lamp = sphere(center: (0, 3, 0), radius: 10cm, radiance: (60, 30, 9))
render main { size 320x180  spp 4 }
`;
const grammar = `grammar cave {
  axiom Room*3
  Room -> + sphere(1m) Hall(2)
  Hall(n) if n > 0 -> + box() Hall(n - 1)
  Hall(n) -> nothing
}
`;
const plant = `grammar plant: lsystem {
  steps 3
  axiom FA(1)
  A(x) -> F[+B]A(x + 1)
  B -> F
}
`;
const kit = 'include "kit/stains.vug" as shore { level -12cm }\nlet rim = shore.pool_rim()\nlet depth = shore.level\n';

/** The text with the marker before the first occurrence of a part, `offset` characters into it. */
function at(text, part, offset = 0) {
  const index = text.indexOf(part) + offset;
  return text.slice(0, index) + "|" + text.slice(index);
}

const document = (method, text, more) => ({ method, text, more });
export const cases = [];
const add = (method, ...texts) => texts.forEach((text) => cases.push(document(method, text)));

add("completion", "|", "let a = 1\nmes|\n", "light key = |\n", "camera c { kind | }\n", "camera c { eye (0, 0, 3)  | }\n",
  "let a = torus(|)\n", "let a = torus(radius: 1m, |)\n", "let a = sphere(radius: 3|)\n", "let a = sphere(1m).tran|\n",
  "grammar g: |\n", at(grammar, "Hall(n - 1)"), "include \"kit/stains.vug\" as shore { | }\n",
  "include \"kit/stains.vug\" as shore\nlet a = shore.|\n", "def f(width) = 2 * |\n", "# nothing|\n");
add("hover", at(scene, "voxel = 4cm", 2), at(scene, "10 * voxel", 6), at(scene, "ball(radius)", 2), at(scene, "hole = ", 1),
  at(scene, "voxel: voxel", 1), at(scene, "spp 4", 1), at(scene, "render main", 1), at(kit, "shore.level", 8),
  at(grammar, "Hall(n - 1)", 1), "let a = sq|rt(2)\n", "# a |comment\n");
add("signatureHelp", "let a = clamp(1, |\n", at(scene, "ball(radius)", 5), "def f(size, turn = 1) = size\nlet a = f(turn: |\n",
  "let a = 1 + |\n");
add("definition", at(scene, "ball(radius)", 1), at(scene, "10 * voxel", 6), at(scene, "on skin", 4), at(scene, "sphere(hole)", 8),
  at(grammar, "Room*3", 1), at(plant, "B]A", 0), at(plant, "x + 1", 0), at(kit, "level -12cm", 1));
add("documentHighlight", at(scene, "voxel = 4cm", 1), at(grammar, "Hall(n)", 1));
cases.push(document("references", at(scene, "radius = ", 1), { context: { includeDeclaration: true } }),
  document("references", at(grammar, "Hall(n)", 1), { context: { includeDeclaration: false } }),
  document("rename", at(scene, "radius = ", 1), { newName: "size" }),
  document("rename", at(scene, "radius = ", 1), { newName: "voxel" }),
  document("rename", at(scene, "radius = ", 1), { newName: "2m" }),
  document("rename", at(plant, "B -> F", 0), { newName: "Branch" }));
add("prepareRename", at(scene, "ball(radius)", 1), at(scene, "level_set", 1), at(plant, "F[+B]", 0));
add("formatting", "let   a=1\nlet b  = [ 1,2 ]\n", "let a = (\n");
add("documentSymbol", scene, grammar + plant);
add("foldingRange", grammar, "# a\n# b\nlet c = [\n  1\n]\n");
add("documentColor", scene, 'let a = srgb("#c0a080")\n');
add("documentLink", kit);
add("codeLens", scene);
add("semanticTokens/full", scene);
cases.push(
  document("colorPresentation", "mesh m on v { paint |(0.5, 0.2, 0.1) }\n", {
    color: { red: 1, green: 0, blue: 0.5, alpha: 1 },
    range: { start: { line: 0, character: 20 }, end: { line: 0, character: 35 } } }),
  document("inlayHint", scene, { range: { start: { line: 0, character: 0 }, end: { line: 9, character: 0 } } }),
  document("codeAction", "volume v = level_set(sphree(1m), voxel: 5cm)\nmesh m on v {}\n", {
    diagnostics: true, range: { start: { line: 0, character: 21 }, end: { line: 0, character: 27 } }, context: { diagnostics: [] } }),
  document("codeAction", "let rim = pool_rim()\nvolume v = level_set(sphere(1m), voxel: 5cm)\nmesh m on v {}\n", {
    diagnostics: true, range: { start: { line: 0, character: 10 }, end: { line: 0, character: 18 } }, context: { diagnostics: [] } }),
  document("codeAction", scene, {
    range: { start: { line: 9, character: 33 }, end: { line: 9, character: 33 } }, context: { diagnostics: [] } }));
