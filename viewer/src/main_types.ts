// SPDX-License-Identifier: BSD-3-Clause
import type { Run } from "./payload/run";
import type { Report } from "./ui/report";

declare global {
  interface Window {
    /** for scripts that draw pictures, and for tests */
    crumple?: { report: Report; run: Run };
  }
}
