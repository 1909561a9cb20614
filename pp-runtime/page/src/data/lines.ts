/** A text as lines counted from 1, and the search in it. */

export class Lines {
  /** Offset of the first character of each line. */
  private readonly starts: number[] = [0];

  constructor(readonly text: string) {
    for (let at = text.indexOf("\n"); at >= 0; at = text.indexOf("\n", at + 1)) this.starts.push(at + 1);
    // A line end at the end of the text does not begin another line.
    if (this.starts.length > 1 && this.starts.at(-1) === text.length) this.starts.pop();
  }

  get count(): number {
    return this.starts.length;
  }

  /** Characters of the longest line. */
  get longest(): number {
    return this.starts.reduce((most, start, i) => Math.max(most, (this.starts[i + 1] ?? this.text.length) - start), 0);
  }

  /** Text of a line without its line end; empty outside the text. */
  line(number: number): string {
    if (number < 1 || number > this.count) return "";
    const end = number < this.count ? this.starts[number] : this.text.length;
    return this.text.slice(this.starts[number - 1], end).replace(/[\r\n]+$/, "");
  }

  /** Line with the character at an offset. */
  lineOfOffset(offset: number): number {
    let low = 0;
    let high = this.starts.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >>> 1;
      if (this.starts[middle] <= offset) low = middle;
      else high = middle - 1;
    }
    return low + 1;
  }

  /** Numbers of the lines that contain `wanted`; upper and lower case are the same. */
  search(wanted: string): number[] {
    const found: number[] = [];
    if (wanted === "") return found;
    const text = this.text.toLowerCase();
    const needle = wanted.toLowerCase();
    // Lower case of some letters is longer than the letter: then offsets do not agree, and lines are searched one by
    // one.
    if (text.length !== this.text.length) {
      for (let line = 1; line <= this.count; line += 1) {
        if (this.line(line).toLowerCase().includes(needle)) found.push(line);
      }
      return found;
    }
    for (let at = text.indexOf(needle); at >= 0; ) {
      const line = this.lineOfOffset(at);
      found.push(line);
      if (line >= this.count) break;
      at = text.indexOf(needle, this.starts[line]);
    }
    return found;
  }
}

/** A part of a block as it is coloured. */
export interface Token {
  text: string;
  kind: "number" | "code" | "comment" | "word";
}

/** Controls on which text in parentheses is a comment; on the others parentheses are of expressions. */
const PARENTHESES = ["linuxcnc", "fanuc", "haas"];

/** Parts of a program line: block number, G and M codes, comments, other words. */
export function tokens(line: string, control: string): Token[] {
  const parts: Token[] = [];
  const pattern = PARENTHESES.includes(control)
    ? /(\([^)]*\)?|;.*$)|(^\s*\/?\s*N\d+)|(\b[GM]\d+(?:\.\d+)?)|([^(;GM]+|.)/gi
    : /(;.*$)|(^\s*\/?\s*(?:N\d+|\d+(?=\s)))|(\b[GM]\d+(?:\.\d+)?)|([^;GM]+|.)/gi;
  for (const match of line.matchAll(pattern)) {
    const kind = match[1] ? "comment" : match[2] ? "number" : match[3] ? "code" : "word";
    const last = parts.at(-1);
    if (last && last.kind === kind && kind === "word") last.text += match[0];
    else parts.push({ text: match[0], kind });
  }
  return parts;
}
