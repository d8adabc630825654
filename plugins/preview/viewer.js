// SPDX-License-Identifier: Apache-2.0
// The model view: orbit controls, the scene's cameras and lights, uniform light, and a cutting plane.
import * as three from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

const GROUND = 0x15171a;
const LUMEN_PER_WATT = 683;  // as in the exporter, see lib/vug/exchange/format.h
const MAX_LIGHTS = 12;       // limit of a forward renderer; the strongest lights are used

export class Viewer {
  constructor(canvas, data) {
    this.canvas = canvas;
    this.data = data;
    this.renderer = new three.WebGLRenderer({ canvas, antialias: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.toneMapping = three.AgXToneMapping;
    this.renderer.localClippingEnabled = true;
    this.scene = new three.Scene();
    this.scene.background = new three.Color(GROUND);
    this.camera = new three.PerspectiveCamera(50, 1, 0.01, 1000);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.12;
    this.controls.autoRotateSpeed = 0.6;
    this.plane = new three.Plane(new three.Vector3(0, -1, 0), 0);
    this.lights = [];
    this.stops = 0;
    this.wanted = true;
    this.controls.addEventListener('change', () => { this.wanted = true; });
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
  }

  async load(bytes) {
    const gltf = await new GLTFLoader().parseAsync(bytes, '');
    this.model = gltf.scene;
    this.scene.add(this.model);
    this.model.updateMatrixWorld(true);
    this.triangles = 0;
    this.materials = new Set();
    this.model.traverse((node) => this.take(node));
    this.box = new three.Box3();
    for (const mesh of this.meshes()) this.box.expandByObject(mesh);
    if (this.box.isEmpty()) this.box.set(new three.Vector3(-1, -1, -1), new three.Vector3(1, 1, 1));
    this.size = this.box.getSize(new three.Vector3()).length();
    this.findCamera(gltf.cameras);
    this.chooseLights();
    this.sceneStops = this.data.exposure ?? this.meteredStops();
    this.addEvenLight();
    this.cut(1);
    this.resize();
    this.goHome();
    this.draw();
    this.loop();
  }

  *meshes() {
    const all = [];
    this.model.traverse((node) => { if (node.isMesh) all.push(node); });
    yield* all;
  }

  take(node) {
    if (node.isLight) this.lights.push(node);
    if (!node.isMesh) return;
    const { index, attributes } = node.geometry;
    this.triangles += (index ? index.count : attributes.position.count) / 3 * (node.isInstancedMesh ? node.count : 1);
    for (const material of [node.material].flat()) {
      if (this.materials.has(material)) continue;
      this.materials.add(material);
      material.clippingPlanes = [this.plane];
      material.side = three.DoubleSide;  // a cut shows the inside
      if (material.emissiveIntensity > 1) material.emissiveIntensity /= LUMEN_PER_WATT;
    }
  }

  findCamera(cameras) {
    const named = cameras.find((each) => each.name === this.data.camera);
    this.own = named ?? cameras[0] ?? null;
  }

  /// Uniform light: a sky, light from the ground and a light at the camera, so that nothing is black.
  addEvenLight() {
    this.even = new three.Group();
    this.even.add(new three.HemisphereLight(0xe6edf5, 0x9a8f82, 1.2));
    const sun = new three.DirectionalLight(0xfff1de, 2.3);
    sun.position.set(0.5, 1, 0.35);
    this.even.add(sun);
    this.scene.add(this.even);
    // Approximates the indirect light of the scene's lights.
    this.fill = new three.HemisphereLight(0xffffff, 0xc8bdb0, 0.2 / 2 ** this.sceneStops);
    this.fill.visible = false;
    this.scene.add(this.fill);
    this.torch = new three.DirectionalLight(0xffffff, 1.2);
    this.torch.position.set(-0.35, 0.4, 1);
    this.torch.target.position.set(0, 0, -1);
    this.camera.add(this.torch, this.torch.target);
    this.scene.add(this.camera);
  }

  chooseLights() {
    for (const light of this.lights) {
      light.intensity /= LUMEN_PER_WATT;
      light.visible = false;
    }
    this.lights.sort((a, b) => b.intensity - a.intensity).splice(MAX_LIGHTS);
  }

  /// For a metered scene: the exposure in stops that shows a grey surface (albedo 0.3) in the middle of the model as 0.16.
  meteredStops() {
    const middle = this.box.getCenter(new three.Vector3()), near = 0.05 * this.size;
    const irradiance = this.lights.reduce((sum, light) => sum + (light.isDirectionalLight ? light.intensity
      : light.intensity / Math.max(near, light.getWorldPosition(new three.Vector3()).distanceTo(middle)) ** 2), 0);
    return irradiance > 0 ? Math.log2(0.16 * Math.PI / (0.3 * irradiance)) : 0;
  }

  useLights(on) {
    for (const light of this.lights) light.visible = on;
    this.fill.visible = on;
    this.even.visible = this.torch.visible = !on;
    this.exposure();
  }

  exposure() {
    const own = this.even.visible ? 0 : this.sceneStops;
    this.renderer.toneMappingExposure = 2 ** (this.stops + own);
    this.wanted = true;
  }
  brighten(stops) {
    this.stops = stops;
    this.exposure();
  }
  showEdges(on) {
    for (const material of this.materials) material.wireframe = on;
    this.wanted = true;
  }
  turn(on) { this.controls.autoRotate = on; }
  /// Cuts the model horizontally and keeps the lower `share` of its height.
  cut(share) {
    const { min, max } = this.box;
    this.plane.constant = min.y + (max.y - min.y) * share + (share >= 1 ? this.size : 0);
    this.wanted = true;
  }

  look(from, to, angle, aspect) {
    this.camera.position.copy(from);
    this.controls.target.copy(to);
    this.angle = angle;
    this.aspect = aspect;
    this.camera.near = this.size * 2e-4;
    this.camera.far = this.size * 20 + from.distanceTo(to);
    this.resize();
    this.controls.update();
    this.wanted = true;
  }

  /// Orbits around the point at the centre of the scene camera's view.
  goHome() {
    if (!this.own) return this.showWhole();
    const from = this.own.getWorldPosition(new three.Vector3());
    const along = this.own.getWorldDirection(new three.Vector3());
    const hits = new three.Raycaster(from, along).intersectObjects([...this.meshes()], false);
    const middle = this.box.getCenter(new three.Vector3()).sub(from).dot(along);
    const far = hits.length ? hits[0].distance : Math.max(middle, this.size * 0.1);
    const to = from.clone().addScaledVector(along, far);
    const wide = this.own.isOrthographicCamera;
    const angle = wide ? 2 * Math.atan2(this.own.top, far) * 180 / Math.PI : this.own.fov;
    this.look(from, to, angle, wide ? this.own.right / this.own.top : this.own.aspect);
  }
  showWhole() {
    const middle = this.box.getCenter(new three.Vector3());
    const way = new three.Vector3(0.55, 0.5, 1).normalize();
    this.look(middle.clone().addScaledVector(way, this.size * 1.15), middle, 50, 1);
  }

  /// Adapts the field of view so that the complete picture of the scene camera is visible.
  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    const half = Math.tan((this.angle ?? 50) * Math.PI / 360);
    const room = Math.max(1, (this.aspect ?? 1) / this.camera.aspect);
    this.camera.fov = Math.atan(half * room) * 360 / Math.PI;
    this.camera.updateProjectionMatrix();
    this.wanted = true;
    if (this.model) this.draw();
  }

  draw() {
    this.wanted = false;
    this.renderer.render(this.scene, this.camera);
  }
  loop() {
    requestAnimationFrame(() => this.loop());
    this.controls.update();
    if (this.wanted) this.draw();
  }
}
