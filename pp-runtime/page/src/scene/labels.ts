/** Labels over the scene: text of constant size at places that move. */

import { Vector3, type Object3D } from "three";
import { element } from "../dom.ts";
import type { LabelAnchor } from "./machine.ts";
import type { View } from "./view.ts";

interface Label {
  object: Object3D;
  node: HTMLElement;
}

export class Labels {
  private readonly layer = element("div", { class: "labels", "aria-hidden": "true" });
  private labels: Label[] = [];

  constructor(private readonly view: View) {
    view.container.append(this.layer);
    view.onFrame(() => this.place());
  }

  set(anchors: LabelAnchor[]): void {
    this.labels = anchors.map(({ object, text, kind, title }) => ({
      object,
      node: element("span", { class: `label ${kind}`, title }, text),
    }));
    this.layer.replaceChildren(...this.labels.map((label) => label.node));
  }

  private place(): void {
    const { width, height } = this.view.size;
    const place = new Vector3();
    for (const { object, node } of this.labels) {
      node.hidden = !isShown(object);
      if (node.hidden) continue;
      object.getWorldPosition(place).project(this.view.camera);
      const x = ((place.x + 1) * width) / 2;
      const y = ((1 - place.y) * height) / 2;
      node.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) translate(-50%, -50%)`;
    }
  }
}

/** Whether an object and all that contains it are visible. */
function isShown(object: Object3D): boolean {
  for (let at: Object3D | null = object; at; at = at.parent) if (!at.visible) return false;
  return true;
}
