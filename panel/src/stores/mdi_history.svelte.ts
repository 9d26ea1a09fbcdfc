// Lines that were entered by hand, newest first; arrow up brings them back.
const kept = 50;

export class MdiHistory {
  lines = $state.raw<string[]>([]);
  #at = -1;

  add(line: string): void {
    this.lines = [line, ...this.lines.filter((one) => one !== line)].slice(0, kept);
    this.#at = -1;
  }

  older(): string | undefined {
    this.#at = Math.min(this.#at + 1, this.lines.length - 1);
    return this.lines[this.#at];
  }

  newer(): string {
    this.#at = Math.max(this.#at - 1, -1);
    return this.lines[this.#at] ?? '';
  }
}

export const mdiHistory = new MdiHistory();
