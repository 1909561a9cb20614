/** Elements, made without markup: text from files is text and nothing else. */

type Attributes = Record<string, string | number | boolean>;

/** An element with attributes and children; a child text becomes a text node. */
export function element<Name extends keyof HTMLElementTagNameMap>(
  name: Name,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[Name] {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === true) made.setAttribute(key, "");
    else if (value !== false) made.setAttribute(key, String(value));
  }
  made.append(...children);
  return made;
}

export interface ButtonOptions {
  label: string;
  /** Drawn instead of the label, which then is the accessible name. */
  icon?: SVGElement;
  /** Key that does the same; shown in the tooltip. */
  key?: string;
  id?: string;
  press: () => void;
}

export function button(options: ButtonOptions): HTMLButtonElement {
  const made = element("button", { type: "button" }, options.icon ?? options.label);
  if (options.icon) made.setAttribute("aria-label", options.label);
  if (options.icon) made.classList.add("icon");
  if (options.id) made.id = options.id;
  made.title = options.key ? `${options.label} (${options.key})` : options.label;
  made.addEventListener("click", options.press);
  return made;
}

/** A line icon of 20 x 20 from the data of its path. */
export function icon(path: string): SVGElement {
  const namespace = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(namespace, "svg");
  svg.setAttribute("viewBox", "0 0 20 20");
  svg.setAttribute("aria-hidden", "true");
  const line = document.createElementNS(namespace, "path");
  line.setAttribute("d", path);
  svg.append(line);
  return svg;
}

/** Removes all children, then adds new ones. */
export function fill(parent: HTMLElement, ...children: (Node | string)[]): void {
  parent.replaceChildren(...children);
}
