# SPDX-License-Identifier: Apache-2.0
"""The Khronos validator reports no problems in the output of vug export."""
import unittest

from external_tools import SCENE, SOURCE, VugTest, node, require_node


class Gltf(VugTest):
    def report(self, scene, name, *options):
        self.expect(0, "export", scene, "-o", "set", "-q", *options)
        report = node("validate_gltf.js", self.folder / "set" / name)
        issues = report["issues"]
        for each in issues["messages"]:
            # The validator knows only the name of this extension and takes its accessors for unused.
            instancing = each["code"] == "UNSUPPORTED_EXTENSION" and "gpu_instancing" in each["message"]
            unused = each["code"] in ("UNUSED_OBJECT", "UNUSED_EXTENSION")
            self.assertTrue(each["severity"] >= 2 and (instancing or unused), each)
        self.assertEqual((issues["numErrors"], issues["numWarnings"]), (0, 0), issues)
        return report["info"]

    def test_a_scene_of_everything(self):
        self.write("all.vug", SCENE)
        info = self.report("all.vug", "all.glb", "--for", "blender")
        self.assertEqual((info["drawCallCount"], info["materialCount"]), (2, 2))
        self.assertEqual(info["maxAttributes"], 4)  # position, normal, colour, wetness

    def test_instances(self):
        self.write("all.vug", SCENE)
        info = self.report("all.vug", "all.glb", "--for", "gltf")
        self.assertIn("EXT_mesh_gpu_instancing", info["extensionsUsed"])

    def test_our_scenes(self):
        for scene in ("teaching/strewn", "teaching/crystals"):
            name = scene.split("/")[1]
            self.report(SOURCE / f"data/scenes/{scene}.vug", f"{name}.glb", "--for", "blender")


if __name__ == "__main__":
    require_node()
    unittest.main()
