// SPDX-License-Identifier: BSD-3-Clause
import { existsSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { unzlibSync } from "fflate";
import { chromium, type Browser, type BrowserContextOptions, type Page } from "playwright-core";

export const root = join(__dirname, "..", "..", "..");
const results = join(root, "build", "viewer", "results");

export async function startBrowser(): Promise<Browser> {
  const executablePath = process.env["CHROMIUM"] ?? "/usr/bin/chromium";
  if (!existsSync(executablePath)) throw new Error(`${executablePath} is missing: "tools/setup report" installs it`);
  // No card is there: chromium draws by its own software.
  const args = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];
  return chromium.launch({ executablePath, args });
}

export function resultAddress(file: string): string {
  return pathToFileURL(join(results, file)).href;
}

export function reportAddress(name: string): string {
  return resultAddress(join(name, "report.html"));
}

export interface OpenReport {
  page: Page;
  /** errors of the console and of scripts, and whatever was asked of a network */
  faults: string[];
}

/** A page whose faults are listed; requests may go to addresses that begin as `allowed` says. */
export async function newPage(browser: Browser, options: BrowserContextOptions, allowed: RegExp): Promise<OpenReport> {
  const context = await browser.newContext(options);
  const page = await context.newPage();
  const faults: string[] = [];
  page.on("console", (message) => {
    // Warnings are the browser's own matter: they change from version to version.
    if (message.type() === "error") faults.push(message.text());
  });
  page.on("pageerror", (fault) => faults.push(fault.message));
  page.on("request", (request) => {
    if (!allowed.test(request.url())) faults.push(`asked for ${request.url()}`);
  });
  return { page, faults };
}

/** Opens a page from its file, without a network, and waits until it has put `ready` into its window. */
export async function openPage(browser: Browser, address: string, ready: string, size: { width: number; height: number }): Promise<OpenReport> {
  const opened = await newPage(browser, { viewport: size, offline: true, hasTouch: size.width < 500 }, /^(file|data|blob):/);
  const { page } = opened;
  await page.goto(address);
  await page.waitForFunction((name) => name in window, ready, { timeout: 120000 });
  return opened;
}

/** Opens the report of a result. */
export async function openReport(browser: Browser, name: string, hash = "", size = { width: 1100, height: 700 }): Promise<OpenReport> {
  return openPage(browser, reportAddress(name) + hash, "crumple", size);
}

export interface Picture {
  width: number;
  height: number;
  /** RGB or RGBA bytes */
  bytes: Uint8Array;
  channels: number;
}

/** A PNG as chromium writes it: eight bits, no interlacing. */
export function decodePng(file: Uint8Array): Picture {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  const width = view.getUint32(16);
  const height = view.getUint32(20);
  const channels = file[25] === 6 ? 4 : 3;
  const packed: Uint8Array[] = [];
  for (let at = 8; at < file.length; ) {
    const length = view.getUint32(at);
    const type = String.fromCharCode(...file.subarray(at + 4, at + 8));
    if (type === "IDAT") packed.push(file.subarray(at + 8, at + 8 + length));
    at += 12 + length;
  }
  const lines = unzlibSync(new Uint8Array(Buffer.concat(packed)));
  const stride = width * channels;
  const bytes = new Uint8Array(height * stride);
  for (let y = 0; y < height; ++y) {
    const filter = lines[y * (stride + 1)];
    for (let x = 0; x < stride; ++x) {
      const left = x >= channels ? bytes[y * stride + x - channels] : 0;
      const up = y > 0 ? bytes[(y - 1) * stride + x] : 0;
      const corner = x >= channels && y > 0 ? bytes[(y - 1) * stride + x - channels] : 0;
      const guess = left + up - corner;
      let added = 0;
      if (filter === 1) added = left;
      else if (filter === 2) added = up;
      else if (filter === 3) added = (left + up) >> 1;
      else if (filter === 4) {
        added = Math.abs(guess - up) < Math.abs(guess - left) ? up : left;
        if (Math.abs(guess - corner) < Math.abs(guess - added)) added = corner;
      }
      bytes[y * stride + x] = lines[y * (stride + 1) + 1 + x] + added;
    }
  }
  return { width, height, bytes, channels };
}

/** The model as the page shows it. */
export async function canvasPicture(page: Page): Promise<Picture> {
  await page.evaluate(() => window.crumple!.report.viewport.draw());
  return decodePng(await page.locator(".canvas").screenshot());
}

/** Share of the pixels that are not of the ground's colour (that of the lower right corner). */
export function coverage(picture: Picture): number {
  const { bytes, channels } = picture;
  const last = bytes.length - channels;
  let count = 0;
  for (let at = 0; at < bytes.length; at += channels)
    if (Math.abs(bytes[at] - bytes[last]) + Math.abs(bytes[at + 1] - bytes[last + 1]) + Math.abs(bytes[at + 2] - bytes[last + 2]) > 24) ++count;
  return (count * channels) / bytes.length;
}

/** Share of the pixels that differ. */
export function difference(a: Picture, b: Picture): number {
  let count = 0;
  for (let at = 0; at < a.bytes.length; at += a.channels)
    if (Math.abs(a.bytes[at] - b.bytes[at]) + Math.abs(a.bytes[at + 1] - b.bytes[at + 1]) + Math.abs(a.bytes[at + 2] - b.bytes[at + 2]) > 24) ++count;
  return (count * a.channels) / a.bytes.length;
}
