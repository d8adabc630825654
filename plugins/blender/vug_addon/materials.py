"""Materials for Cycles and Eevee: what varies over a mesh comes from its attributes, the rest is numbers."""
CHANNELS = ("Cd", "roughness", "wetness", "metallic", "transmission", "opacity", "through", "emission")


def channels_of(surface):
    return tuple(name for name in CHANNELS if name in surface.attributes)


def socket(node, *names):
    """The input that has the first of these names: Blender 4 has renamed some."""
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
        """The attribute where the mesh has it, else the number."""
        if name in channels:
            self.links.new(self.attribute(name, output), target)
        else:
            target.default_value = value


def extension(gltf, name, key, fallback):
    return gltf.get("extensions", {}).get(f"KHR_materials_{name}", {}).get(key, fallback)


# Luminance of a black body in W/sr/m2, as Vug counts it: A exp(-B / kelvin), within 2 % from 1000 to 3000 K.
BLACK_BODY = 5.63e8, 24580


class VolumeShader(Tree):
    """A volume's shaders, from what a cloud says of its grids."""

    def __init__(self, material, about):
        super().__init__(material)
        self.about = about
        flame = "flame" in about["grids"]
        # Where it shines, per metre: its flame, or how much light the place stops.
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
    """Fills a material with what a cloud says. Blender's extinction is that of all colours, too, where
    nothing is absorbed beyond the albedo."""
    tree = VolumeShader(material, about)
    out = tree.body()
    for part in ([tree.emission()] if any(about["emission"]) else []) + ([tree.heat()] if about["heat"] else []):
        out = tree.sum(out, part)
    tree.links.new(out, tree.add("ShaderNodeOutputMaterial", 4).inputs["Volume"])


def build(material, gltf, channels):
    """Fills a material with what a glTF material says. What is only matte becomes a diffuse surface,
    as Vug's is; Blender's Principled BSDF is no Lambertian surface at any setting."""
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
        facing = ((ior - 1) / (ior + 1)) ** 2  # what is mirrored straight on; 0.08 is at 1 in Blender 3
        socket(shader, "Specular", "Specular IOR Level").default_value = specular * (
            facing / 0.08 if "Specular" in shader.inputs else 0.5)
    out = shader.outputs[0]
    through = gltf.get("extras", {}).get("vug:through")
    if through:  # a thin sheet's back shines with what comes from its front
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
    if "opacity" in channels or color[3] < 1:  # what is not there is looked through
        air, both = tree.add("ShaderNodeBsdfTransparent", 2), tree.add("ShaderNodeMixShader", 3)
        tree.feed(both.inputs[0], channels, "opacity", color[3])
        tree.links.new(air.outputs[0], both.inputs[1])
        tree.links.new(out, both.inputs[2])
        out = both.outputs[0]
        if hasattr(material, "blend_method"):  # of Eevee
            material.blend_method = "HASHED"
    tree.links.new(out, tree.add("ShaderNodeOutputMaterial", 4).inputs["Surface"])
