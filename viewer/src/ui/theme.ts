// SPDX-License-Identifier: BSD-3-Clause

export type Theme = "light" | "dark";

/** Light or dark: the system's choice until the user makes one; paper is always light. */
export class Themes {
  private readonly system = window.matchMedia("(prefers-color-scheme: dark)");
  private chosen: Theme | null = null;
  private printing = false;
  private readonly listeners: (() => void)[] = [];

  constructor() {
    this.system.addEventListener("change", () => this.apply());
    window.addEventListener("beforeprint", () => this.setPrinting(true));
    window.addEventListener("afterprint", () => this.setPrinting(false));
    this.apply();
  }

  get theme(): Theme {
    if (this.printing) return "light";
    return this.chosen ?? (this.system.matches ? "dark" : "light");
  }

  /** what the user chose; null follows the system */
  get choice(): Theme | null {
    return this.chosen;
  }

  choose(theme: Theme | null): void {
    this.chosen = theme;
    this.apply();
  }

  toggle(): void {
    this.choose(this.theme === "dark" ? "light" : "dark");
  }

  /** Called now and at every change. */
  watch(listener: () => void): void {
    this.listeners.push(listener);
    listener();
  }

  /** A colour of the style sheet. */
  colour(name: string): string {
    return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
  }

  private setPrinting(on: boolean): void {
    this.printing = on;
    this.apply();
  }

  private apply(): void {
    document.documentElement.dataset["theme"] = this.theme;
    for (const listener of this.listeners) listener();
  }
}
