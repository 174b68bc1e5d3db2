// SPDX-License-Identifier: BSD-3-Clause
import { defineConfig } from "vitest/config";

export default defineConfig({
  // Two cores, and a browser that draws by software: one file after the other.
  test: { fileParallelism: false, testTimeout: 240000, hookTimeout: 240000 },
});
