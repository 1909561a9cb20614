/** Keys of the page, and the overlay that lists them. */

import { button, element } from "./dom.ts";

export interface Command {
  /** `KeyboardEvent.key`, with `Shift+` before it where shift counts. */
  keys: string[];
  /** As it is printed; without it the keys are. */
  shown?: string;
  label: string;
  run: () => void;
}

export interface CommandGroup {
  title: string;
  commands: Command[];
}

export class Keyboard {
  private readonly commands = new Map<string, Command>();
  private readonly dialog: HTMLDialogElement;

  constructor(groups: CommandGroup[]) {
    const help: CommandGroup = {
      title: "Help",
      commands: [{ keys: ["?"], label: "this list", run: () => this.toggleHelp() }],
    };
    for (const command of [...groups, help].flatMap((group) => group.commands)) {
      for (const key of command.keys) this.commands.set(key, command);
    }
    this.dialog = helpDialog([...groups, help]);
    document.body.append(this.dialog);
    document.addEventListener("keydown", (event) => this.press(event));
  }

  toggleHelp(): void {
    if (this.dialog.open) this.dialog.close();
    else this.dialog.showModal();
  }

  private press(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    const target = event.target as HTMLElement;
    // A field takes its own keys; so does a list, a slider its arrows, and a button Space and Enter.
    if (target.closest("input[type=search], textarea")) return;
    if (target.closest("select") && event.key !== "?" && event.key !== "Escape") return;
    if (target.closest("input") && /^(Arrow|Home|End|Page| )/.test(event.key)) return;
    if (target.closest("button, summary, a") && (event.key === " " || event.key === "Enter")) return;
    if (this.dialog.open && event.key !== "?") return;
    // Letters are the same with caps lock; shift is a key of its own.
    const letter = /^[a-z]$/i.test(event.key);
    const name = event.key.length === 1 && !letter ? event.key : `${event.shiftKey ? "Shift+" : ""}${letter ? event.key.toLowerCase() : event.key}`;
    const command = this.commands.get(name);
    if (!command) return;
    event.preventDefault();
    command.run();
  }
}

function helpDialog(groups: CommandGroup[]): HTMLDialogElement {
  const dialog = element("dialog", { id: "help-dialog", "aria-label": "Keys" });
  const close = button({ label: "Close", press: () => dialog.close() });
  close.autofocus = true;
  const columns = groups.map((group) =>
    element(
      "section",
      {},
      element("h3", {}, group.title),
      element(
        "dl",
        {},
        ...group.commands.flatMap((command) => [
          element("dt", {}, ...(command.shown ?? command.keys.map(printed).join(" ")).split(" ").map((key) => element("kbd", {}, key))),
          element("dd", {}, command.label),
        ]),
      ),
    ),
  );
  const mouse = element("p", { class: "note" }, "Pointer: drag to orbit, right button or two fingers to pan, wheel or pinch to zoom, click a line of the path to go there. In plots: drag to zoom, Shift and wheel to zoom, click to go there.");
  dialog.append(element("header", {}, element("h2", {}, "Keys"), close), element("div", { class: "columns" }, ...columns), mouse);
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close();
  });
  return dialog;
}

const NAMES: Record<string, string> = { " ": "Space", ArrowLeft: "←", ArrowRight: "→", ArrowUp: "↑", ArrowDown: "↓" };

const printed = (key: string): string =>
  key
    .split(/(?<=Shift)\+/)
    .map((part) => NAMES[part] ?? (part.length === 1 ? part.toUpperCase() : part))
    .join("+");
