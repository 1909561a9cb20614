/** What is shown and how: colouring with its legend, layers, machine, what is fixed, extent of the path. */

import { scaleText, type Colouring } from "../colour/colouring.ts";
import { cssColour, type Theme } from "../colour/scale.ts";
import { element, fill } from "../dom.ts";
import type { Fixed, MachineStyle } from "../scene/machine.ts";
import type { PathExtent } from "../scene/path.ts";
import type { Stage } from "../scene/stage.ts";

export interface DisplayEvents {
  colour: (name: string) => void;
  hold: (fixed: Fixed) => void;
}

export class DisplayPanel {
  readonly root = element("section", { class: "panel", "aria-label": "Display" });
  private readonly select = element("select", { id: "colouring", "aria-label": "Colour of the path", title: "Colour of the path (C)" });
  private readonly legend = element("div", { class: "legend" });
  private readonly layerList = element("div", { class: "layers" });
  private readonly choices: { update: () => void }[] = [];

  constructor(
    list: Colouring[],
    private readonly stage: Stage,
    events: DisplayEvents,
    rapidsApart: boolean,
  ) {
    for (const colouring of list) this.select.append(element("option", { value: colouring.name }, colouring.label));
    this.select.addEventListener("change", () => events.colour(this.select.value));
    this.root.append(
      element("h2", {}, "Path"),
      labelled("Colour", this.select),
      this.legend,
      rapidsApart ? element("p", { class: "note" }, "In rapids each axis moves on its own: their path is not the line drawn.") : "",
      this.choice<PathExtent>("Shown (H)", "extent", [["whole", "all"], ["done", "done"], ["operation", "operation"]], () => stage.extent, (value) => stage.setExtent(value)),
      element("h2", {}, "Machine"),
      this.choice<Fixed>("At rest (B)", "fixed", [["machine", "machine"], ["part", "part"]], () => stage.fixed, events.hold),
      this.choice<MachineStyle>("Bodies (M)", "style", [["solid", "solid"], ["ghost", "clear"], ["off", "off"]], () => stage.machineStyle, (value) => stage.setMachineStyle(value)),
      element("h2", {}, "Layers"),
      this.layerList,
    );
    stage.layers.onChange(() => this.updateLayers());
    this.updateLayers();
  }

  /** Shows the choices as they are now. */
  update(): void {
    for (const choice of this.choices) choice.update();
  }

  showColouring(colouring: Colouring, theme: Theme): void {
    this.select.value = colouring.name;
    const legend = colouring.legend(theme);
    if ("entries" in legend) {
      const items = legend.entries.map((entry) => {
        const sample = element("span", { class: entry.dashed ? "sample dashed" : "sample" });
        sample.style.setProperty("--sample", entry.colour);
        return element("li", {}, sample, entry.label);
      });
      fill(this.legend, element("ul", {}, ...items));
      return;
    }
    const { scale } = legend;
    const table = colouring.table(theme);
    const stops = Array.from({ length: 17 }, (_, i) => cssColour(table[Math.round((i / 16) * (table.length - 1))]));
    const bar = element("div", { class: "scale" });
    bar.style.background = `linear-gradient(to right, ${stops.join(", ")})`;
    if (scale.mark && scale.max > scale.min) {
      const share = (scale.mark.value - scale.min) / (scale.max - scale.min);
      if (share >= 0 && share <= 1) {
        const mark = element("span", { class: "scale-mark", title: `${scale.mark.label} ${scaleText(scale.mark.value, scale.unit)}` });
        mark.style.left = `${(100 * share).toFixed(1)}%`;
        bar.append(mark);
      }
    }
    const middle = (scale.min + scale.max) / 2;
    fill(
      this.legend,
      bar,
      element(
        "div",
        { class: "scale-numbers" },
        element("span", {}, scaleText(scale.min, scale.unit)),
        element("span", {}, scaleText(middle, scale.unit)),
        element("span", {}, `${scale.beyond ? "≥ " : ""}${scaleText(scale.max, scale.unit)}`),
      ),
      scale.mark ? element("p", { class: "note" }, `${scale.mark.label} ${scaleText(scale.mark.value, scale.unit)}`) : "",
      element("p", { class: "note" }, element("span", { class: "sample unknown" }), "no value"),
    );
  }

  private updateLayers(): void {
    const focused = document.activeElement instanceof HTMLElement ? document.activeElement.dataset.layer : undefined;
    fill(
      this.layerList,
      ...this.stage.layers.list.map((layer) => {
        const box = element("input", { type: "checkbox", "data-layer": layer.name });
        box.checked = layer.visible;
        box.addEventListener("change", () => this.stage.layers.set(layer.name, box.checked));
        const sample = element("span", { class: `sample-place` }, layer.sample ? element("span", { class: layer.sample }) : "");
        return element("label", {}, box, sample, layer.label, layer.key ? element("kbd", {}, layer.key) : "");
      }),
    );
    if (focused) this.layerList.querySelector<HTMLElement>(`[data-layer="${focused}"]`)?.focus();
  }

  /** A row of radio buttons. */
  private choice<Value extends string>(
    label: string,
    name: string,
    values: [Value, string][],
    get: () => Value,
    set: (value: Value) => void,
  ): HTMLElement {
    const inputs = values.map(([value, text]) => {
      const input = element("input", { type: "radio", name, value });
      input.addEventListener("change", () => set(value));
      return { input, value, node: element("label", {}, input, element("span", {}, text)) };
    });
    const update = (): void => {
      for (const { input, value } of inputs) input.checked = value === get();
    };
    update();
    this.choices.push({ update });
    return element("fieldset", { class: "choice" }, element("legend", {}, label), element("div", {}, ...inputs.map((each) => each.node)));
  }
}

const labelled = (label: string, control: HTMLElement): HTMLElement => element("label", { class: "labelled" }, element("span", {}, label), control);
