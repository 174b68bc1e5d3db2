// SPDX-License-Identifier: BSD-3-Clause
import "../style.css";
import "./live.css";
import { Themes } from "../ui/theme";
import { LivePage } from "./live_page";
import { ReportFrames } from "./report_frames";
import { Strip } from "./strip";

new Themes();
const reports = new ReportFrames(document.getElementById("reports")!);
void new LivePage(new Strip(document.getElementById("strip")!), reports).follow();
