/** A bar between two parts of the page that is dragged, or moved with the arrow keys. */

import { element } from "./dom.ts";

/** Step of an arrow key, px. */
const STEP_PX = 24;

/**
 * `column`: between columns; the size is that of the part on the left. `row`: between rows; the size is that of the
 * part below. The size is the custom property `property` of `host`.
 */
export function splitter(
  label: string,
  direction: "column" | "row",
  host: HTMLElement,
  property: string,
  leastPx: number,
  mostPx: number,
): HTMLElement {
  const bar = element("div", {
    class: `splitter ${direction}`,
    role: "separator",
    tabindex: "0",
    "aria-label": label,
    "aria-orientation": direction === "column" ? "vertical" : "horizontal",
    "aria-valuemin": leastPx,
    "aria-valuemax": mostPx,
  });
  const sizePx = (): number => {
    const sized = direction === "column" ? bar.previousElementSibling : bar.nextElementSibling;
    const { width, height } = sized?.getBoundingClientRect() ?? { width: leastPx, height: leastPx };
    return direction === "column" ? width : height;
  };
  const set = (wanted: number): void => {
    const size = Math.round(Math.min(Math.max(wanted, leastPx), mostPx));
    host.style.setProperty(property, `${size}px`);
    bar.setAttribute("aria-valuenow", String(size));
  };
  bar.addEventListener("pointerdown", (event) => {
    event.preventDefault();
    bar.setPointerCapture(event.pointerId);
    const start = { x: event.clientX, y: event.clientY, size: sizePx() };
    const move = (moved: PointerEvent): void => {
      set(start.size + (direction === "column" ? moved.clientX - start.x : start.y - moved.clientY));
    };
    bar.addEventListener("pointermove", move);
    for (const end of ["pointerup", "pointercancel"] as const) {
      bar.addEventListener(end, () => bar.removeEventListener("pointermove", move), { once: true });
    }
  });
  bar.addEventListener("keydown", (event) => {
    const larger = direction === "column" ? "ArrowRight" : "ArrowUp";
    const smaller = direction === "column" ? "ArrowLeft" : "ArrowDown";
    if (event.key !== larger && event.key !== smaller) return;
    event.preventDefault();
    event.stopPropagation();
    set(sizePx() + (event.key === larger ? STEP_PX : -STEP_PX));
  });
  return bar;
}
