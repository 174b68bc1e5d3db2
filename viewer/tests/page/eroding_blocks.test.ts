// SPDX-License-Identifier: BSD-3-Clause
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import type { Browser } from "playwright-core";
import { canvasPicture, coverage, difference, openReport, reportAddress, startBrowser } from "./page";
import "../../src/main_types";

/** Solids that erode, shells on top, a truss. */
describe("the report of blocks that are pulled apart", () => {
  let browser: Browser;
  beforeAll(async () => {
    browser = await startBrowser();
  });
  afterAll(() => browser.close());

  it("shows faces that erosion brings to light", async () => {
    const { page, faults } = await openReport(browser, "eroding_blocks", "#field=");
    const facts = await page.evaluate(() => {
      const { run } = window.crumple!;
      const { faces, faceCount, lineCount } = run.mesh;
      let inner = 0;
      for (let face = 0; face < faceCount; ++face) if (faces[5 * faceCount + face] >= 0) ++inner;
      return { inner, lineCount, dead: [...run.death].filter((death) => death < run.frames).length, types: [...new Set(run.cellType)].sort() };
    });
    expect(facts.dead).toBe(4);
    expect(facts.inner).toBe(8);
    expect(facts.lineCount).toBe(1);
    expect(facts.types).toEqual([12, 3, 9]);
    const whole = await canvasPicture(page);
    await page.evaluate(() => window.crumple!.report.player.goTo(20));
    const torn = await canvasPicture(page);
    expect(difference(whole, torn)).toBeGreaterThan(0.02);
    expect(coverage(torn)).toBeGreaterThan(0.1);
    // The weak blocks are gone: to hide them changes nothing.
    await page.locator('[data-part="2"]').uncheck();
    expect(difference(await canvasPicture(page), torn)).toBeLessThan(0.001);
    expect(faults).toEqual([]);
    await page.context().close();
  });

  it("is used by touch on a small screen", async () => {
    const size = { width: 390, height: 780 };
    const { page, faults } = await openReport(browser, "eroding_blocks", "#field=von_mises", size);
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    expect(width).toBe(390);
    const canvas = (await page.locator(".canvas").boundingBox())!;
    await page.touchscreen.tap(canvas.x + canvas.width / 2, canvas.y + canvas.height / 2);
    expect(await page.evaluate(() => window.crumple!.report.picked !== null)).toBe(true);
    await page.locator(".player .play").tap();
    await page.waitForFunction(() => window.crumple!.report.player.place() > 0.2);
    expect(faults).toEqual([]);
    await page.context().close();
  });

  it("has its curves and tables where WebGL is missing", async () => {
    const page = await browser.newPage();
    await page.addInitScript(() => {
      HTMLCanvasElement.prototype.getContext = new Proxy(HTMLCanvasElement.prototype.getContext, {
        apply: (get, canvas, [kind, ...rest]: [string]) => (kind.startsWith("webgl") ? null : Reflect.apply(get, canvas, [kind, ...rest])),
      });
    });
    await page.goto(reportAddress("eroding_blocks"));
    await page.locator("#tables").waitFor();
    expect(await page.locator("#crumple-message").textContent()).toContain("WebGL");
    expect(await page.locator("#curves canvas").count()).toBeGreaterThan(2);
    await page.close();
  });

  it("sets what is shown by the address", async () => {
    const { page, faults } = await openReport(browser, "eroding_blocks", "#frame=last&field=pressure&view=%2Bx&theme=dark&picture");
    expect(await page.locator("header").isVisible()).toBe(false);
    expect(await page.locator(".legend b").textContent()).toBe("Pressure");
    expect(await page.evaluate(() => window.crumple!.report.player.frame)).toBe(20);
    expect(faults).toEqual([]);
    await page.context().close();
  });
});
