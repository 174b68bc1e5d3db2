// SPDX-License-Identifier: BSD-3-Clause
import "../main_types";
import { h } from "../ui/dom";
import type { Report } from "../ui/report";

const pause = (milliseconds: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, milliseconds));

/** None where the browser cannot draw the model. Before it is set, the name means the element of that id. */
function reportIn(frame: HTMLIFrameElement): Report | undefined {
  return (frame.contentWindow!.crumple as Partial<NonNullable<Window["crumple"]>> | undefined)?.report;
}

/** The report in a frame of its own. The next one is read behind it and takes its place, and what the user has set, at
 * once; with the frame goes all that the one before held, of the graphics card as well. */
export class ReportFrames {
  private current: HTMLIFrameElement | null = null;
  private pressed = false;
  private readonly theme = new MutationObserver(() => this.followTheme());

  constructor(private readonly host: HTMLElement) {}

  /** Shows the present report. Throws the server's reason if there is none. */
  async load(): Promise<void> {
    const next = h("iframe", { class: "coming", title: "report", src: "report#live&frame=last" });
    const loaded = new Promise((resolve) => next.addEventListener("load", resolve, { once: true }));
    this.host.append(next);
    try {
      await loaded;
      const page = next.contentDocument;
      if (!page?.getElementById("crumple")) throw new Error(page?.body.textContent?.trim() || "The report cannot be had.");
      const state = () => page.documentElement.dataset["report"];
      // The script stands at the end.
      if (state() === undefined) throw new Error("The report broke off.");
      while (state() !== "settled") await pause(30);
    } catch (fault) {
      next.remove();
      throw fault;
    }
    // A drag goes on in the frame that it began in.
    while (this.pressed) await pause(100);
    this.replaceBy(next);
  }

  private replaceBy(next: HTMLIFrameElement): void {
    const last = this.current;
    const kept = last && reportIn(last)?.settings;
    const report = reportIn(next);
    if (kept && report) report.settings = kept;
    this.listen(next.contentWindow!);
    next.classList.remove("coming");
    if (last && document.activeElement === last) {
      // The focus stays where it was, for whoever uses the keys.
      const label = last.contentDocument!.activeElement?.getAttribute("aria-label");
      next.focus();
      if (label) next.contentDocument!.querySelector<HTMLElement>(`[aria-label="${CSS.escape(label)}"]`)?.focus({ preventScroll: true });
    }
    // Taken out and put in again, the new frame would be read anew.
    for (const other of [...this.host.children]) if (other !== next) other.remove();
    this.current = next;
    this.theme.disconnect();
    this.theme.observe(next.contentDocument!.documentElement, { attributeFilter: ["data-theme"] });
    this.followTheme();
  }

  private listen(frame: Window): void {
    this.pressed = false;
    frame.addEventListener("pointerdown", () => (this.pressed = true), true);
    for (const end of ["pointerup", "pointercancel", "blur"]) frame.addEventListener(end, () => (this.pressed = false), true);
  }

  private followTheme(): void {
    const theme = this.current?.contentDocument?.documentElement.dataset["theme"];
    if (theme) document.documentElement.dataset["theme"] = theme;
  }
}
