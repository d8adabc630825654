# SPDX-License-Identifier: Apache-2.0
"""Materials for Cycles and Eevee. Varying properties come from mesh attributes, the others are constants."""
CHANNELS = ("Cd", "roughness", "wetness", "metallic", "transmission", "opacity", "through", "emission")


def channels_of(surface):
    return tuple(name for name in CHANNELS if name in surface.attributes)


def socket(node, *names):
    """The input with the first of these names that exists; Blender 4 renamed some inputs."""
    for name in names:
        if name in node.inputs:
            return node.inputs[name]
    raise KeyError(names[0])


class Tree:
    def __init__(self, material):
        material.use_nodes = True
        self.nodes, self.links = material.node_tree.nodes, material.node_tree.links
        self.nodes.clear()
        self._row = 0

    def add(self, kind, column):
        node = self.nodes.new(kind)
        node.location = (300 * column, -200 * self._row)
        self._row += 1
        return node

    def attribute(self, name, output):
        node = self.add("ShaderNodeAttribute", 0)
        node.attribute_type, node.attribute_name, node.label = "GEOMETRY", name, name
        return node.outputs[output]

    def sum(self, a, b):
        both = self.add("ShaderNodeAddShader", 2)
        self.links.new(a, both.inputs[0])
        self.links.new(b, both.inputs[1])
        return both.outputs[0]

    def feed(self, target, channels, name, value, output="Fac"):
        """Connects the attribute if the mesh has it, otherwise sets the constant."""
        if name in channels:
            self.links.new(self.attribute(name, output), target)
        else:
            target.default_value = value


def extension(gltf, name, key, fallback):
    return gltf.get("extensions", {}).get(f"KHR_materials_{name}", {}).get(key, fallback)


# Luminance of a black body in W/sr/m2, in Vug's units: A exp(-B / kelvin), within 2 % from 1000 to 3000 K.
BLACK_BODY = 5.63e8, 24580


class VolumeShader(Tree):
    """Shader nodes of a volume, from its exported description."""

    def __init__(self, material, about):
        super().__init__(material)
        self.about = about
        flame = "flame" in about["grids"]
        # Density of the emission per metre: the flame grid, or the extinction.
        self.place, self.per_metre = ("flame", 1) if flame else ("density", about["extinction"])

    def math(self, operation, *inputs):
        node = self.add("ShaderNodeMath", 1)
        node.operation = operation
        for socket_, value in zip(node.inputs, inputs):
            if isinstance(value, (int, float)):
                socket_.default_value = value
            else:
                self.links.new(value, socket_)
        return node.outputs[0]

    def body(self):
        shader = self.add("ShaderNodeVolumePrincipled", 2)
        shader.inputs["Density"].default_value = self.about["extinction"]
        shader.inputs["Density Attribute"].default_value = "density"
        shader.inputs["Temperature Attribute"].default_value = ""
        shader.inputs["Anisotropy"].default_value = self.about["forward"]
        self.feed(shader.inputs["Color"], self.about["grids"], "color", (*self.about["albedo"], 1), "Color")
        return shader.outputs[0]

    def glow(self, strength):
        shader = self.add("ShaderNodeEmission", 2)
        self.links.new(self.math("MULTIPLY", self.attribute(self.place, "Fac"), strength),
                       shader.inputs["Strength"])
        return shader

    def emission(self):
        most = max(self.about["emission"])
        shader = self.glow(most * self.per_metre)
        shader.inputs["Color"].default_value = (*(part / most for part in self.about["emission"]), 1)
        return shader.outputs[0]

    def heat(self):
        kelvin = self.math("MAXIMUM", self.attribute("temperature", "Fac"), 100)
        shine = self.math("EXPONENT", self.math("DIVIDE", -BLACK_BODY[1], kelvin))
        shader = self.glow(self.math("MULTIPLY", shine, BLACK_BODY[0] * self.about["heat"] * self.per_metre))
        color = self.add("ShaderNodeBlackbody", 1)
        self.links.new(kelvin, color.inputs[0])
        self.links.new(color.outputs[0], shader.inputs["Color"])
        return shader.outputs[0]


def build_volume(material, about):
    """Builds a volume material from an exported description. Blender's extinction is also the same for all
    colours if there is no absorption besides the albedo."""
    tree = VolumeShader(material, about)
    out = tree.body()
    for part in ([tree.emission()] if any(about["emission"]) else []) + ([tree.heat()] if about["heat"] else []):
        out = tree.sum(out, part)
    tree.links.new(out, tree.add("ShaderNodeOutputMaterial", 4).inputs["Volume"])


def build(material, gltf, channels):
    """Builds a material from a glTF material. A purely diffuse material becomes a diffuse BSDF, as in Vug, because
    Blender's Principled BSDF is not Lambertian with any settings."""
    tree = Tree(material)
    body = gltf.get("pbrMetallicRoughness", {})
    color = body.get("baseColorFactor", (1, 1, 1, 1))
    metallic = body.get("metallicFactor", 1)
    specular = extension(gltf, "specular", "specularFactor", 1)
    ior = extension(gltf, "ior", "ior", 1.5)
    coat = extension(gltf, "clearcoat", "clearcoatFactor", 0)
    clear = extension(gltf, "transmission", "transmissionFactor", 0)
    matte = not (metallic or specular or coat or clear or
                 {"wetness", "metallic", "transmission"} & set(channels))
    if matte:
        shader = tree.add("ShaderNodeBsdfDiffuse", 1)
        tree.feed(shader.inputs["Color"], channels, "Cd", color, "Color")
    else:
        shader = tree.add("ShaderNodeBsdfPrincipled", 1)
        tree.feed(shader.inputs["Base Color"], channels, "Cd", color, "Color")
        tree.feed(shader.inputs["Roughness"], channels, "roughness", body.get("roughnessFactor", 1))
        tree.feed(shader.inputs["Metallic"], channels, "metallic", metallic)
        tree.feed(socket(shader, "Clearcoat", "Coat Weight"), channels, "wetness", coat)
        tree.feed(socket(shader, "Transmission", "Transmission Weight"), channels, "transmission", clear)
        socket(shader, "Clearcoat Roughness", "Coat Roughness").default_value = extension(
            gltf, "clearcoat", "clearcoatRoughnessFactor", 0.1)
        shader.inputs["IOR"].default_value = ior
        facing = ((ior - 1) / (ior + 1)) ** 2  # reflectance at normal incidence; in Blender 3, 0.08 corresponds to 1
        socket(shader, "Specular", "Specular IOR Level").default_value = specular * (
            facing / 0.08 if "Specular" in shader.inputs else 0.5)
    out = shader.outputs[0]
    through = gltf.get("extras", {}).get("vug:through")
    if through:  # light that a thin sheet transmits diffusely
        sheet = tree.add("ShaderNodeBsdfTranslucent", 1)
        tree.feed(sheet.inputs["Color"], channels, "through", (*through, 1), "Color")
        out = tree.sum(out, sheet.outputs[0])
    shine = gltf.get("emissiveFactor", (0, 0, 0))
    if any(shine):
        emission = tree.add("ShaderNodeEmission", 1)
        strength = extension(gltf, "emissive_strength", "emissiveStrength", 1)
        if "emission" in channels:
            tree.links.new(tree.attribute("emission", "Color"), emission.inputs["Color"])
            strength = 1
        else:
            emission.inputs["Color"].default_value = (*shine, 1)
        emission.inputs["Strength"].default_value = strength
        out = tree.sum(out, emission.outputs[0])
    if "opacity" in channels or color[3] < 1:  # cut-out surface
        air, both = tree.add("ShaderNodeBsdfTransparent", 2), tree.add("ShaderNodeMixShader", 3)
        tree.feed(both.inputs[0], channels, "opacity", color[3])
        tree.links.new(air.outputs[0], both.inputs[1])
        tree.links.new(out, both.inputs[2])
        out = both.outputs[0]
        if hasattr(material, "blend_method"):  # Eevee only
            material.blend_method = "HASHED"
    tree.links.new(out, tree.add("ShaderNodeOutputMaterial", 4).inputs["Surface"])
