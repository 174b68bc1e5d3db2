// SPDX-License-Identifier: BSD-3-Clause
import type { Browser, Page } from "playwright-core";
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, it } from "vitest";
import { canvasPicture, coverage, difference, openReport, startBrowser } from "./page";
import "../../src/main_types";

/** Shells, an infinite wall, contact: the box beam of the paper's first example, a third of its time. */
describe("the report of the box beam", () => {
  let browser: Browser;
  let page: Page;
  let faults: string[];

  beforeAll(async () => {
    browser = await startBrowser();
  });
  afterAll(() => browser.close());
  beforeEach(async () => {
    ({ page, faults } = await openReport(browser, "box_beam"));
  });
  afterEach(async () => {
    await page.context().close();
    expect(faults).toEqual([]);
  });

  it("shows the model, and that it moves", async () => {
    const start = await canvasPicture(page);
    expect(coverage(start)).toBeGreaterThan(0.05);
    await page.locator(".player input").fill("18.5");
    const later = await canvasPicture(page);
    expect(coverage(later)).toBeGreaterThan(0.05);
    expect(difference(start, later)).toBeGreaterThan(0.02);
    expect(await page.locator(".clock").textContent()).toMatch(/t = 0\.0037\s+frame 19 \/ 20/);
  });

  it("plays and stops by the space bar, steps by arrows", async () => {
    await page.locator(".canvas canvas").focus();
    await page.keyboard.press("Space");
    await page.waitForFunction(() => window.crumple!.report.player.place() > 0.5);
    await page.keyboard.press("Space");
    const stopped = await page.evaluate(() => window.crumple!.report.player.place());
    await page.waitForTimeout(150);
    expect(await page.evaluate(() => window.crumple!.report.player.place())).toBe(stopped);
    await page.keyboard.press("End");
    await page.keyboard.press("ArrowLeft");
    expect(await page.evaluate(() => window.crumple!.report.player.place())).toBe(19);
    await page.keyboard.press("Home");
    expect(await page.evaluate(() => window.crumple!.report.player.place())).toBe(0);
  });

  it("colours by every field, with a legend and a range", async () => {
    await page.evaluate(() => window.crumple!.report.player.goTo(15));
    await page.locator("#field").selectOption("");
    const byPart = await canvasPicture(page);
    expect(await page.locator(".legend").isVisible()).toBe(false);
    const names = await page.locator("#field option").evaluateAll((list) => list.map((entry) => (entry as HTMLOptionElement).value));
    for (const name of ["plastic_strain", "von_mises", "thickness", "velocity", "contact_force", "displacement"])
      expect(names).toContain(name);
    const seen = [byPart];
    for (const name of ["plastic_strain", "von_mises", "velocity", "displacement"]) {
      await page.locator("#field").selectOption(name);
      expect(await page.locator(".legend").isVisible()).toBe(true);
      const picture = await canvasPicture(page);
      for (const other of seen) expect(difference(other, picture)).toBeGreaterThan(0.01);
      seen.push(picture);
    }
    await page.locator("#range").selectOption("frame");
    const numbers = await page.locator(".legend .numbers span").allTextContents();
    expect(numbers.length).toBe(13);
    await page.locator(".pair input").last().fill("0.01");
    await page.locator(".pair input").last().dispatchEvent("change");
    expect((await page.locator(".legend .numbers span").allTextContents())[0]).toBe("0.01");
  });

  it("switches parts off and on", async () => {
    await page.locator("#field").selectOption("");
    const whole = await canvasPicture(page);
    await page.locator('[data-part="1"]').uncheck();
    const rest = await canvasPicture(page);
    expect(coverage(rest)).toBeLessThan(0.8 * coverage(whole));
    await page.getByRole("button", { name: "all" }).click();
    expect(difference(await canvasPicture(page), whole)).toBeLessThan(0.001);
  });

  it("has edges, the undeformed model and a section", async () => {
    await page.evaluate(() => window.crumple!.report.player.goTo(20));
    const plain = await canvasPicture(page);
    for (const what of ["edges", "undeformed", "walls", "section"]) {
      await page.getByLabel(what, { exact: true }).click();
      expect(difference(await canvasPicture(page), plain), what).toBeGreaterThan(0.005);
      await page.getByLabel(what, { exact: true }).click();
      expect(difference(await canvasPicture(page), plain), what).toBeLessThan(0.001);
    }
    await page.getByLabel("section", { exact: true }).check();
    const half = await canvasPicture(page);
    await page.getByLabel("place of the section").fill("0.25");
    expect(difference(await canvasPicture(page), half)).toBeGreaterThan(0.01);
  });

  it("picks what is clicked and shows its history", async () => {
    // Where the middle of a shell that faces the eye is seen.
    const target = await page.evaluate(() => {
      const { report, run } = window.crumple!;
      report.setView("+z");
      report.viewport.camera.updateMatrixWorld();
      const faces = run.mesh.faces;
      const count = run.mesh.faceCount;
      const middle = [0, 1, 2].map((axis) => [0, 1, 2, 3].reduce((sum, corner) => sum + run.position(0, faces[corner * count + 200])[axis] / 4, 0));
      const at = report.view.toWorld(middle as [number, number, number]).project(report.viewport.camera);
      const { clientWidth, clientHeight } = report.viewport.renderer.domElement;
      return { x: ((at.x + 1) / 2) * clientWidth, y: ((1 - at.y) / 2) * clientHeight };
    });
    await page.evaluate(() => window.crumple!.report.viewport.draw());
    await page.locator(".canvas").click({ position: target });
    const pick = await page.evaluate(({ x, y }) => {
      const { report, run } = window.crumple!;
      const pick = report.picked;
      if (!pick) return null;
      // By hand: of all faces, is the place inside that one, and is its nearest corner the node?
      const project = (node: number) => {
        const at = report.view.toWorld(run.position(0, node)).project(report.viewport.camera);
        const { clientWidth, clientHeight } = report.viewport.renderer.domElement;
        return [((at.x + 1) / 2) * clientWidth, ((1 - at.y) / 2) * clientHeight];
      };
      const corners = pick.outline.filter((_, i) => i % 2 === 0);
      const distances = corners.map((node) => Math.hypot(project(node)[0] - x, project(node)[1] - y));
      return {
        element: run.elementId[pick.cell],
        node: run.nodeId[pick.node],
        nearest: run.nodeId[corners[distances.indexOf(Math.min(...distances))]],
        near: Math.min(...distances),
      };
    }, target);
    expect(pick).not.toBeNull();
    expect(pick!.node).toBe(pick!.nearest);
    expect(pick!.near).toBeLessThan(40);
    const facts = (await page.locator(".selection dl").textContent())!;
    expect(facts).toContain(String(pick!.node));
    expect(facts).toContain(`${pick!.element} (part 1)`);
    await page.locator("#history").selectOption("displacement");
    expect(await page.locator(".selection canvas").isVisible()).toBe(true);
    expect(await page.locator("figure select").inputValue()).toBe("picked");
    await page.keyboard.press("Escape");
    expect(await page.locator(".selection dl").isVisible()).toBe(false);
  });

  it("moves a line through the curves with the time, and goes where they are clicked", async () => {
    const over = page.locator("figure", { hasText: "Energies" }).locator(".u-over");
    const box = (await over.boundingBox())!;
    await over.click({ position: { x: box.width / 2, y: box.height / 2 } });
    const now = await page.evaluate(() => window.crumple!.report.player.now);
    expect(now).toBeGreaterThan(0.0019);
    expect(now).toBeLessThan(0.0021);
    const line = (await over.locator(".moment").boundingBox())!;
    expect(Math.abs(line.x - box.x - box.width / 2)).toBeLessThan(3);
  });

  it("leaves its arrows to the slider of the section", async () => {
    await page.getByLabel("section", { exact: true }).check();
    const slider = page.getByLabel("place of the section");
    await slider.focus();
    await page.keyboard.press("ArrowRight");
    expect(Number(await slider.inputValue())).toBeGreaterThan(0.5);
    expect(await page.evaluate(() => window.crumple!.report.player.place())).toBe(0);
  });

  it("turns and zooms by the mouse", async () => {
    const before = await canvasPicture(page);
    const box = (await page.locator(".canvas").boundingBox())!;
    await page.mouse.move(box.x + 300, box.y + 200);
    await page.mouse.down();
    await page.mouse.move(box.x + 420, box.y + 260, { steps: 4 });
    await page.mouse.up();
    const turned = await canvasPicture(page);
    expect(difference(before, turned)).toBeGreaterThan(0.02);
    expect(await page.evaluate(() => window.crumple!.report.picked)).toBeNull();
    await page.mouse.wheel(0, 600);
    expect(coverage(await canvasPicture(page))).not.toBeCloseTo(coverage(turned), 3);
  });

  it("filters forces by the classes that their sampling allows", async () => {
    const filter = page.getByLabel("filter", { exact: true });
    const plot = page.locator("figure", { hasText: "Wall forces" }).locator("canvas");
    const raw = await plot.evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL());
    await filter.selectOption("60");
    expect(await plot.evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL())).not.toBe(raw);
    // In microseconds the same samples lie a million times closer.
    await page.getByLabel("unit of time", { exact: true }).selectOption("us");
    expect(await page.locator("#curves .controls small").first().textContent()).toContain("Hz");
  });

  it("has its curves and tables", async () => {
    const headings = await page.locator("figcaption").allTextContents();
    for (const heading of ["Energies", "Energy ratio", "Wall forces", "Force over displacement", "Time step and the element that controls it", "Added mass"])
      expect(headings).toContain(heading);
    const tables = await page.locator("article h3").allTextContents();
    for (const heading of ["Checks", "Parts", "Run", "Timings", "Contacts"]) expect(tables).toContain(heading);
    expect(await page.locator("#tables").textContent()).toContain("end plate");
  });

  it("changes between light and dark", async () => {
    const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const first = await ground();
    await page.keyboard.press("t");
    expect(await ground()).not.toBe(first);
    await page.keyboard.press("t");
    expect(await ground()).toBe(first);
  });

  it("prints the picture, the curves and the tables", async () => {
    const pdf = await page.pdf({ format: "A4" });
    expect(pdf.length).toBeGreaterThan(50000);
    expect(await page.locator(".paper").evaluate((image) => (image as HTMLImageElement).naturalWidth)).toBeGreaterThan(300);
  });
});
