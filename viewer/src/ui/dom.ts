// SPDX-License-Identifier: BSD-3-Clause

type Attributes = Record<string, string | number | boolean | ((event: never) => void) | undefined>;
type Child = Node | string | null | undefined;

/** An element with attributes (functions are listeners, `class` and the like are strings) and children. */
export function h<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    if (typeof value === "function") element.addEventListener(name, value as unknown as EventListener);
    else element.setAttribute(name, value === true ? "" : String(value));
  }
  for (const child of children) if (child !== null && child !== undefined) element.append(child);
  return element;
}

export function options(select: HTMLSelectElement, entries: [value: string, text: string][]): void {
  const kept = select.value;
  select.replaceChildren(...entries.map(([value, text]) => h("option", { value }, text)));
  if (entries.some(([value]) => value === kept)) select.value = kept;
}

/** As if the user chose it, if it is there and another one was chosen. */
export function choose(select: HTMLSelectElement, value: string): void {
  const option = [...select.options].find((other) => other.value === value);
  if (!option || option.disabled || select.value === value) return;
  select.value = value;
  select.dispatchEvent(new Event("change"));
}

export function labelled(text: string, control: HTMLElement): HTMLLabelElement {
  return h("label", { class: "field" }, h("span", {}, text), control);
}

export function toggle(text: string, checked: boolean, change: (on: boolean) => void, key?: string): HTMLLabelElement {
  const box = h("input", { type: "checkbox" });
  box.checked = checked;
  box.addEventListener("change", () => change(box.checked));
  return h("label", { class: "toggle", title: key ? `key ${key}` : undefined }, box, h("span", {}, text));
}

/** The checkbox of a toggle. */
export function boxOf(label: HTMLLabelElement): HTMLInputElement {
  return label.querySelector("input")!;
}

export function setBox(label: HTMLLabelElement, on: boolean): void {
  const box = boxOf(label);
  if (box.checked === on) return;
  box.checked = on;
  box.dispatchEvent(new Event("change"));
}
