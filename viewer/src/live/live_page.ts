// SPDX-License-Identifier: BSD-3-Clause
import type { ReportFrames } from "./report_frames";
import type { Status } from "./status";
import type { Strip } from "./strip";

const pollInterval = 1000;
/** A program that is busy may miss an answer. */
const mostMisses = 3;
/** Reading a report takes at most one part in so many of the time. */
const restFactor = 4;

/** Asks how far the run is, and for its report when there are new frames, until it has ended. */
export class LivePage {
  private shownFrames = 0;
  private shownEnd = false;
  private restUntil = 0;
  private misses = 0;
  private loading = false;

  constructor(
    private readonly strip: Strip,
    private readonly reports: ReportFrames,
  ) {}

  async follow(): Promise<void> {
    for (;;) {
      const start = performance.now();
      const status = await this.ask();
      if (status) this.strip.show(status);
      if (this.misses >= mostMisses) {
        this.strip.showGone();
        return;
      }
      if (status) void this.update(status);
      if (this.shownEnd || (status?.state === "ended" && status.frames === 0)) return;
      await new Promise((resolve) => setTimeout(resolve, Math.max(0, start + pollInterval - performance.now())));
    }
  }

  private async ask(): Promise<Status | null> {
    try {
      const answer = await fetch("status", { signal: AbortSignal.timeout(5000) });
      if (!answer.ok) throw new Error(answer.statusText);
      this.misses = 0;
      return (await answer.json()) as Status;
    } catch {
      ++this.misses;
      return null;
    }
  }

  /** Polling goes on meanwhile: the program waits at its end for pages that ask. */
  private async update(status: Status): Promise<void> {
    const ended = status.state === "ended";
    const isNew = status.frames > this.shownFrames || (ended && !this.shownEnd);
    const start = performance.now();
    if (!isNew || status.frames === 0 || this.loading || (start < this.restUntil && !ended)) return;
    this.loading = true;
    try {
      await this.reports.load();
      this.shownFrames = status.frames;
      this.shownEnd = ended;
      this.strip.setFault("");
    } catch (fault) {
      this.strip.setFault(fault instanceof Error ? fault.message : String(fault));
    }
    this.loading = false;
    this.restUntil = performance.now() + restFactor * (performance.now() - start);
  }
}
