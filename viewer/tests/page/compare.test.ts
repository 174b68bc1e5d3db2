// SPDX-License-Identifier: BSD-3-Clause
import type { Browser } from "playwright-core";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { openPage, resultAddress, startBrowser, type OpenReport } from "./page";

describe("crumple compare --html", () => {
  let browser: Browser;
  let open: OpenReport;

  beforeAll(async () => {
    browser = await startBrowser();
    open = await openPage(browser, resultAddress("compare.html"), "crumpleComparison", { width: 1100, height: 700 });
  }, 120000);
  afterAll(() => browser.close());

  it("has a row for each curve, the worst first", async () => {
    const relative = await open.page.evaluate(() => window.crumpleComparison!.comparison.curves.map((curve) => curve.relative!));
    expect(relative.length).toBeGreaterThan(10);
    expect([...relative].sort((a, b) => b - a)).toEqual(relative);
    // Both precisions agree up to rounding.
    expect(relative[0]).toBeGreaterThan(0);
    expect(relative[0]).toBeLessThan(0.01);
    expect(await open.page.locator("#scores tbody tr").count()).toBe(relative.length);
    expect(await open.page.locator("#scores .badge.excellent").count()).toBe(relative.length);
  });

  it("draws the curves that are seen", async () => {
    await open.page.locator("#curves").scrollIntoViewIfNeeded();
    await open.page.waitForSelector("#curve-0 canvas");
    expect(await open.page.locator("#curve-0 .u-legend .u-series").count()).toBe(3);
  });

  it("shows one group or grade", async () => {
    await open.page.selectOption("select[aria-label=group]", "rwforc");
    const shown = await open.page.locator("#scores tbody tr:visible td:first-child").allTextContents();
    expect(shown.length).toBeGreaterThan(0);
    for (const name of shown) expect(name).toMatch(/^rwforc\./);
    expect(await open.page.locator("figure.chart:visible").count()).toBe(shown.length);
    await open.page.selectOption("select[aria-label=group]", "");
  });

  it("is light or dark, and draws all for paper", async () => {
    await open.page.keyboard.press("t");
    expect(await open.page.evaluate(() => document.documentElement.dataset["theme"])).toBe("dark");
    await open.page.pdf({ format: "A4" });
    const drawn = await open.page.locator("figure.chart canvas").count();
    expect(drawn).toBe(await open.page.locator("figure.chart").count());
  });

  it("asks for nothing and has no errors", () => {
    expect(open.faults).toEqual([]);
  });
});
