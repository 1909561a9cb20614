/** Renderer, camera and its controls. A frame is drawn when something has changed, and at no other time. */

import {
  Box3,
  Color,
  HemisphereLight,
  DirectionalLight,
  OrthographicCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { styleColour } from "../theme.ts";

/** Standard views: direction from the target to the eye, and up on the screen. */
export const STANDARD_VIEWS = {
  iso: { label: "Isometric", key: "1", eye: [1, -1.25, 0.9], up: [0, 0, 1] },
  top: { label: "Top", key: "2", eye: [0, 0, 1], up: [0, 1, 0] },
  front: { label: "Front", key: "3", eye: [0, -1, 0], up: [0, 0, 1] },
  right: { label: "Right", key: "4", eye: [1, 0, 0], up: [0, 0, 1] },
  left: { label: "Left", key: "5", eye: [-1, 0, 0], up: [0, 0, 1] },
  back: { label: "Back", key: "6", eye: [0, 1, 0], up: [0, 0, 1] },
  bottom: { label: "Bottom", key: "7", eye: [0, 0, -1], up: [0, -1, 0] },
} as const;

/** From this number of legs on lines are not smoothed where there is no graphics card: it takes three times as long. */
const MOST_SMOOTH_LEGS = 20_000;

/** Room around what is fitted, px: at the top for the buttons, elsewhere for labels of half their size. */
const INSET = { top: 56, bottom: 22, side: 28 };

export type StandardView = keyof typeof STANDARD_VIEWS;

export class View {
  readonly scene = new Scene();
  readonly camera = new OrthographicCamera(-1, 1, 1, -1, -1e5, 1e5);
  readonly controls: OrbitControls;
  private readonly renderer: WebGLRenderer;
  private readonly beforeFrame: (() => void)[] = [];
  private scheduled = false;
  private width = 1;
  private height = 1;

  constructor(
    readonly container: HTMLElement,
    legs: number,
  ) {
    this.renderer = new WebGLRenderer({ antialias: legs < MOST_SMOOTH_LEGS || !drawsInSoftware(), powerPreference: "high-performance" });
    const canvas = this.renderer.domElement;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", "Tool path and machine in 3-D. Drag to orbit; press ? for the keys.");
    container.append(canvas);
    // Z is up: the controls turn about the camera's up vector, which they read when they are made.
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(1, -1.25, 0.9).normalize();
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("change", () => this.request());
    const sky = new HemisphereLight(0xffffff, 0x8d949c, 1.9);
    sky.position.set(0, 0, 1);
    const lamp = new DirectionalLight(0xffffff, 1.5);
    lamp.position.set(0.4, -0.8, 1);
    this.scene.add(sky, lamp);
    new ResizeObserver(() => this.resize()).observe(container);
    this.resize();
    this.restyle();
  }

  get canvas(): HTMLCanvasElement {
    return this.renderer.domElement;
  }

  get size(): { width: number; height: number } {
    return { width: this.width, height: this.height };
  }

  /** mm of one pixel on the screen. */
  get mmPerPixel(): number {
    return (this.camera.top - this.camera.bottom) / this.camera.zoom / this.height;
  }

  onFrame(prepare: () => void): void {
    this.beforeFrame.push(prepare);
  }

  request(): void {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame(() => {
      this.scheduled = false;
      this.draw();
    });
  }

  /** Time of one frame in ms, drawn now and waited for: the middle one of three. */
  frameMilliseconds(): number {
    const gl = this.renderer.getContext();
    const pixel = new Uint8Array(4);
    const times = [0, 1, 2].map(() => {
      const start = performance.now();
      this.draw();
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      return performance.now() - start;
    });
    return times.sort((a, b) => a - b)[1];
  }

  restyle(): void {
    this.scene.background = new Color(styleColour("--viewport"));
    this.request();
  }

  /** Looks at places from where the camera is, as near as they fit beside the buttons. */
  fit(places: Vector3[]): void {
    if (places.length === 0) return;
    const box = new Box3().setFromPoints(places);
    const radius = Math.max(box.getSize(new Vector3()).length() / 2, 0.5);
    this.place(box.getCenter(new Vector3()), radius);
    const right = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0);
    const up = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1);
    const extent = (direction: Vector3): [number, number] => {
      const along = places.map((place) => place.dot(direction));
      return [along.reduce((low, value) => Math.min(low, value)), along.reduce((high, value) => Math.max(high, value))];
    };
    const [left, toRight] = extent(right);
    const [bottom, top] = extent(up);
    const wide = Math.max(this.width - 2 * INSET.side, 40);
    const high = Math.max(this.height - INSET.top - INSET.bottom, 40);
    this.camera.zoom = Math.min(wide / Math.max(toRight - left, 0.5), high / Math.max(top - bottom, 0.5));
    this.camera.updateProjectionMatrix();
    const { target } = this.controls;
    const downMm = (INSET.top - INSET.bottom) / 2 / this.camera.zoom;
    this.centreOn(
      target
        .clone()
        .addScaledVector(right, (left + toRight) / 2 - target.dot(right))
        .addScaledVector(up, (bottom + top) / 2 - target.dot(up) + downMm),
    );
  }

  look(view: StandardView, places: Vector3[]): void {
    const { eye } = STANDARD_VIEWS[view];
    const box = new Box3().setFromPoints(places);
    const centre = box.getCenter(new Vector3());
    const distance = Math.max(box.getSize(new Vector3()).length() * 4, 10);
    this.controls.target.copy(centre);
    this.camera.position.copy(centre).addScaledVector(new Vector3(eye[0], eye[1], eye[2]).normalize(), distance);
    if (eye[0] === 0 && eye[1] === 0) this.camera.position.y -= 1e-6 * distance;
    this.camera.lookAt(centre);
    this.controls.update();
    this.fit(places);
  }

  /** Looks at the target from a direction. */
  lookFrom(direction: Vector3): void {
    const distance = this.camera.position.distanceTo(this.controls.target);
    this.camera.position.copy(this.controls.target).addScaledVector(direction.clone().normalize(), distance);
    this.controls.update();
    this.request();
  }

  /** Moves the point that the camera looks at. */
  centreOn(point: Vector3): void {
    const shift = point.clone().sub(this.controls.target);
    this.controls.target.add(shift);
    this.camera.position.add(shift);
    this.controls.update();
    this.request();
  }

  /** Moves the picture by pixels, to the right and down. */
  panBy(rightPx: number, downPx: number): void {
    const right = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0);
    const up = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1);
    const shift = right.multiplyScalar(-rightPx * this.mmPerPixel).addScaledVector(up, downPx * this.mmPerPixel);
    this.centreOn(this.controls.target.clone().add(shift));
  }

  zoomBy(factor: number): void {
    this.camera.zoom *= factor;
    this.camera.updateProjectionMatrix();
    this.request();
  }

  /** Orbits by angles in rad: about the vertical, and up or down. */
  orbitBy(aroundRad: number, overRad: number): void {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const radius = offset.length();
    const around = Math.atan2(offset.y, offset.x) + aroundRad;
    const over = Math.min(Math.max(Math.asin(offset.z / radius) + overRad, -Math.PI / 2 + 1e-4), Math.PI / 2 - 1e-4);
    offset.set(Math.cos(over) * Math.cos(around), Math.cos(over) * Math.sin(around), Math.sin(over));
    this.camera.position.copy(this.controls.target).addScaledVector(offset, radius);
    this.controls.update();
    this.request();
  }

  private place(centre: Vector3, radius: number): void {
    const direction = this.camera.position.clone().sub(this.controls.target);
    if (direction.length() < 1e-9) direction.set(1, -1.25, 0.9);
    direction.normalize();
    this.controls.target.copy(centre);
    this.camera.position.copy(centre).addScaledVector(direction, 8 * radius);
    this.camera.lookAt(centre);
    this.camera.near = -40 * radius;
    this.camera.far = 60 * radius;
    this.camera.updateMatrixWorld();
  }

  private resize(): void {
    this.width = Math.max(this.container.clientWidth, 1);
    this.height = Math.max(this.container.clientHeight, 1);
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(this.width, this.height);
    this.camera.left = -this.width / 2;
    this.camera.right = this.width / 2;
    this.camera.top = this.height / 2;
    this.camera.bottom = -this.height / 2;
    this.camera.updateProjectionMatrix();
    // Setting the size empties the canvas: draw at once, so that it does not flash.
    this.draw();
  }

  private draw(): void {
    for (const prepare of this.beforeFrame) prepare();
    this.renderer.render(this.scene, this.camera);
  }
}

/** Whether the browser draws without a graphics card, as far as it tells. */
function drawsInSoftware(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  const info = gl?.getExtension("WEBGL_debug_renderer_info");
  if (!gl || !info) return false;
  const name = String(gl.getParameter(info.UNMASKED_RENDERER_WEBGL));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}
