// SPDX-License-Identifier: BSD-3-Clause
import type { Browser, Page } from "playwright-core";
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, it } from "vitest";
import { openReport, startBrowser } from "./page";
import "../../src/main_types";

/** The box beam as it is and with its nodes moved by up to 1e-3 of its diagonal, three runs. */
describe("the report of a scatter", () => {
  let browser: Browser;
  let page: Page;
  let faults: string[];

  beforeAll(async () => {
    browser = await startBrowser();
  });
  afterAll(() => browser.close());
  beforeEach(async () => {
    ({ page, faults } = await openReport(browser, "box_beam_scatter"));
  });
  afterEach(async () => {
    await page.context().close();
    expect(faults).toEqual([]);
  });

  const chart = (heading: string) => page.locator("figure", { has: page.getByText(heading, { exact: true }) });

  /** Pixels that are a quarter blue, as the area of the first curve's band is. */
  const areaOf = (heading: string) =>
    chart(heading)
      .locator("canvas")
      .evaluate((canvas: HTMLCanvasElement) => {
        const { data } = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
        let count = 0;
        for (let at = 0; at < data.length; at += 4)
          if (data[at + 3] > 55 && data[at + 3] < 75 && data[at + 2] > 1.5 * data[at]) ++count;
        return count;
      });

  it("draws the bands under the curves of the unperturbed run", async () => {
    expect(await areaOf("Wall forces")).toBeGreaterThan(1000);
    const key = await chart("Wall forces").locator(".band-key span").allTextContents();
    expect(key).toEqual(["unperturbed run", "median", "P5 to P95 of 3 runs, nodes moved by up to 0.001 of the diagonal"]);
    expect(await chart("Force over displacement").locator(".band-key").count()).toBe(0);
    expect(await page.locator("#tables").textContent()).toContain("unperturbed one of 3 runs");
  });

  it("finds the bands of all curves by their names", async () => {
    const missing = await page.evaluate(() => {
      const { run } = window.crumple!;
      const columns = run.history("glstat.csv")!.columns.filter((name) => name !== "time");
      const names = [...columns.map((name) => `glstat.${name}`), "matsum.internal[1]", "matsum.internal[2]", "rwforc.normal[1]"];
      return names.filter((name) => {
        const band = run.band(name);
        return !band || band.times.length < 50 || band.low.some((low, i) => low > band.median[i] || band.median[i] > band.high[i]);
      });
    });
    expect(missing).toEqual([]);
  });

  it("switches a band off with its curve", async () => {
    await chart("Wall forces").locator(".u-legend .u-series", { hasText: "wall 1" }).locator("th").click();
    expect(await areaOf("Wall forces")).toBe(0);
  });

  it("draws no bands around filtered forces", async () => {
    await page.getByLabel("filter", { exact: true }).selectOption("600");
    expect(await chart("Wall forces").locator(".band-key").count()).toBe(0);
    expect(await page.locator("#curves .controls small").first().textContent()).toContain("bands are of unfiltered forces");
    expect(await areaOf("Wall forces")).toBeLessThan(200);
    await page.getByLabel("filter", { exact: true }).selectOption("0");
    expect(await areaOf("Wall forces")).toBeGreaterThan(1000);
  });

  it("has none in the report of one run", async () => {
    const alone = await openReport(browser, "box_beam");
    expect(await alone.page.locator(".band-key").count()).toBe(0);
    expect(alone.faults).toEqual([]);
    await alone.page.context().close();
  });
});
