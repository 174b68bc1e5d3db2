// SPDX-License-Identifier: BSD-3-Clause
import { defineConfig } from "vitest/config";

export default defineConfig({
  // Two cores, and a browser that draws by software: one file after the other.
  test: { fileParallelism: false, testTimeout: 30000, hookTimeout: 60000 },
});
