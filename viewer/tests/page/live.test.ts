// SPDX-License-Identifier: BSD-3-Clause
import { spawn, type ChildProcess } from "node:child_process";
import { rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Browser, Page } from "playwright-core";
import { afterAll, afterEach, beforeAll, describe, expect, it } from "vitest";
import type { ReportSettings } from "../../src/ui/report_settings";
import { newPage, root, startBrowser } from "./page";
import "../../src/main_types";

const results = join(root, "build", "viewer", "results", "live");

/** Starts a run of the square tube, half a second for each unit of time, and gives the address of its page. */
async function startRun(end: number): Promise<{ program: ChildProcess; address: string; code: Promise<number | null> }> {
  rmSync(results, { recursive: true, force: true });
  const deck = join(root, "examples", "04_square_tube", "square_tube.k");
  const program = spawn(join(root, "build", "release", "crumple"), ["run", deck, "-o", results, "-t", "1", "--serve", "0", "--end", String(end)]);
  const code = new Promise<number | null>((resolve) => program.on("exit", resolve));
  const address = await new Promise<string>((resolve, reject) => {
    let printed = "";
    program.stdout.on("data", (text: Buffer) => {
      printed += text.toString();
      // With the token, which is the first folder of the address.
      const found = /(http:\/\/127\.0\.0\.1:\d+\/\S*)\n/.exec(printed);
      if (found) resolve(found[1]);
    });
    program.on("exit", () => reject(new Error(`no address in: ${printed}`)));
  });
  return { program, address, code };
}

/** Something of the report that is shown now; the function must not use anything around it. */
function ofReport<T>(page: Page, what: (frame: Window) => T): Promise<T> {
  return page.evaluate<T>(`(${what.toString()})(document.querySelector("#reports iframe:not(.coming)").contentWindow)`);
}
const frames = (page: Page): Promise<number> => ofReport(page, (frame) => frame.crumple!.run.frames);
const settings = (page: Page): Promise<ReportSettings> => ofReport(page, (frame) => frame.crumple!.report.settings);

async function waitForFrames(page: Page, most: number): Promise<number> {
  await page.waitForFunction((known) => {
    const shown = document.querySelector<HTMLIFrameElement>("#reports iframe:not(.coming)")?.contentWindow;
    return (shown?.crumple?.run.frames ?? 0) > known;
  }, most, { timeout: 180000 });
  return frames(page);
}

async function waitForEnd(page: Page, termination: string): Promise<void> {
  await page.waitForFunction((state) => document.querySelector("#strip .state")!.textContent === state, `ended: ${termination}`, { timeout: 180000 });
}

function expectSame(now: number[], before: number[]): void {
  now.forEach((value, axis) => expect(value).toBeCloseTo(before[axis], 4));
}

describe("the live page", () => {
  let browser: Browser;
  let page: Page;
  let faults: string[];
  let run: Awaited<ReturnType<typeof startRun>>;

  beforeAll(async () => {
    browser = await startBrowser();
  });
  afterAll(() => browser.close());
  // The browser is ready before the run starts: a short run does not wait for one that comes late.
  async function follow(end: number): Promise<void> {
    ({ page, faults } = await newPage(browser, { viewport: { width: 1100, height: 700 } }, /^(data|blob|http:\/\/127\.0\.0\.1):/));
    run = await startRun(end);
    await page.goto(run.address);
  }
  afterEach(async () => {
    run.program.kill("SIGKILL");
    await page.context().close();
  });

  // However slow the browser is, the run is not at its end before a switch ends it.
  it("follows a run and keeps what is set, until a switch ends it", async () => {
    await follow(1000);
    const first = await waitForFrames(page, 0);
    expect((await settings(page)).player.atEnd).toBe(true);
    expect(await page.locator("#strip .state").textContent()).toBe("running");
    // The frame of the start is there before the first cycles are.
    await expect.poll(() => page.locator("#strip .facts").textContent(), { timeout: 10000 }).toMatch(/^t = \S+ of 1000 .* \d+ % .* cycle \d+ .* to go$/);

    await ofReport(page, (frame) => {
      const { report } = frame.crumple!;
      report.setView("+y");
      report.pickAt(report.viewport.host.clientWidth / 2, report.viewport.host.clientHeight / 2);
      report.viewport.camera.position.multiplyScalar(0.7);
      report.panel.setField("velocity");
      report.panel.section.click();
      report.parts.set(0, false);
      report.player.element.querySelector("select")!.value = "2";
    });
    await page.frameLocator("#reports iframe:not(.coming)").getByRole("button", { name: "light or dark (t)" }).click();
    const before = await settings(page);
    const second = await waitForFrames(page, first);
    const after = await settings(page);
    expectSame(after.eye, before.eye);
    expectSame(after.target, before.target);
    expect(after.player).toEqual({ ...before.player, time: after.player.time });
    expect(after.player.time).toBeGreaterThan(before.player.time);
    expect(after.panel.field).toBe("velocity");
    expect(after.panel.section).toBe(true);
    expect(after.panel.cut).toBeCloseTo(before.panel.cut, 9);
    expect(after.hiddenParts).toEqual(before.hiddenParts);
    expect(after.hiddenParts.length).toBe(1);
    expect(after.theme).toBe("dark");
    expect(before.picked).not.toBeNull();
    expect(after.picked).toEqual(before.picked);
    expect(await page.evaluate(() => document.documentElement.dataset["theme"])).toBe("dark");

    // Away from the end, the moment stays.
    await ofReport(page, (frame) => frame.crumple!.report.player.goTo(2));
    const { time } = (await settings(page)).player;
    await waitForFrames(page, second);
    expect((await settings(page)).player).toMatchObject({ time, atEnd: false });

    writeFileSync(join(results, "d3kil"), "sw1\n");
    await waitForEnd(page, "interrupted");
    expect(await run.code).toBe(5);
  }, 300000);

  it("shows the end of a run", async () => {
    await follow(4);
    await waitForEnd(page, "normal");
    expect(await run.code).toBe(0);
    expect(await ofReport(page, (frame) => frame.crumple!.run.meta.run?.termination)).toBe("normal");
    expect(await page.locator("iframe").count()).toBe(1);
    // The page is still alive, and asks for nothing any more.
    await ofReport(page, (frame) => frame.crumple!.report.player.goTo(0));
    expect((await settings(page)).player.time).toBe(0);
    await page.waitForTimeout(2500);
    expect(faults).toEqual([]);
  }, 240000);

  it("says that the program was killed", async () => {
    await follow(1000);
    await waitForFrames(page, 0);
    run.program.kill("SIGKILL");
    await page.waitForFunction(() => document.querySelector("#strip .state")!.textContent!.startsWith("no answer any more"), null, { timeout: 30000 });
    const misses = faults.length;
    await page.waitForTimeout(2500);
    expect(faults.length).toBe(misses);
    // What the browser itself says of requests that fail.
    expect(faults.filter((fault) => !/net::ERR_/.test(fault))).toEqual([]);
    expect(await frames(page)).toBeGreaterThan(0);
  }, 60000);
});
