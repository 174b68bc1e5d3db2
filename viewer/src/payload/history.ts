// SPDX-License-Identifier: BSD-3-Clause

/** A CSV history: one array per column; text columns stay text. */
export interface History {
  /** kind of history, which its file is named after: "rwforc" of rwforc.csv */
  group: string;
  /** which wall, part, ... these rows belong to, if they are those of one */
  item: string;
  columns: string[];
  text: Record<string, string[]>;
  number: Record<string, Float64Array>;
  rows: number;
}

/** What bands and `crumple compare` call a column (name_of in crumple/compare/curves/curve.hpp): `rwforc.normal[3]`. */
export function curveName(history: History, quantity: string): string {
  const item = history.item === "" ? "" : `[${history.item}]`;
  return `${history.group}.${quantity}${item}`;
}

export function parseHistory(csv: string, group = ""): History {
  const lines = csv.split("\n").filter((line) => line.length > 0);
  const columns = lines.length > 0 ? lines[0].split(",") : [];
  const cells = lines.slice(1).map((line) => line.split(","));
  const history: History = { group, item: "", columns, text: {}, number: {}, rows: cells.length };
  columns.forEach((name, place) => {
    const texts = cells.map((row) => row[place] ?? "");
    history.text[name] = texts;
    history.number[name] = Float64Array.from(texts, (cell) => (cell === "" ? NaN : Number(cell)));
  });
  return history;
}

/** The rows of a history that belong to one item, such as a wall; items in the order they come in. `keys` are the
 * columns that tell items apart, in the order of the file. */
export function splitBy(history: History, keys: string[]): Map<string, History> {
  const rows = new Map<string, number[]>();
  for (let row = 0; row < history.rows; ++row) {
    const item = keys.map((key) => history.text[key][row]).join(" ");
    let list = rows.get(item);
    if (!list) rows.set(item, (list = []));
    list.push(row);
  }
  const parts = new Map<string, History>();
  for (const [item, list] of rows) {
    const part: History = { group: history.group, item, columns: history.columns, text: {}, number: {}, rows: list.length };
    for (const name of history.columns) {
      part.text[name] = list.map((row) => history.text[name][row]);
      part.number[name] = Float64Array.from(list, (row) => history.number[name][row]);
    }
    parts.set(item, part);
  }
  return parts;
}
