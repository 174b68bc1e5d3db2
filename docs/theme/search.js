// SPDX-License-Identifier: BSD-3-Clause
// Looks for words in all pages. The index comes as a script (tools/build_docs), because a page that was opened as
// a file may not fetch anything else.
const base = document.currentScript.dataset.base;
const query = document.getElementById("query");
const found = document.getElementById("found");
const mostResults = 20;

function loadIndex() {
  if (window.searchIndex || document.getElementById("search-index")) return;
  const script = document.createElement("script");
  script.id = "search-index";
  script.src = `${base}/search/search_index.js`;
  script.onload = showResults;
  document.head.append(script);
}

// Sections with all the words; those with the words in their title come first.
function sectionsWith(words) {
  const ranked = [];
  for (const section of window.searchIndex.docs) {
    const title = section.title.toLowerCase();
    const text = section.text.toLowerCase();
    if (!words.every((word) => title.includes(word) || text.includes(word))) continue;
    ranked.push({ section, inTitle: words.filter((word) => title.includes(word)).length });
  }
  return ranked.sort((a, b) => b.inTitle - a.inTitle).slice(0, mostResults).map((entry) => entry.section);
}

function excerpt(text, word) {
  const from = Math.max(0, text.toLowerCase().indexOf(word) - 40);
  return `${from > 0 ? "... " : ""}${text.slice(from, from + 120)} ...`;
}

function showResults() {
  const words = query.value.toLowerCase().split(/\s+/).filter(Boolean);
  found.replaceChildren();
  found.hidden = words.length === 0;
  if (words.length === 0 || !window.searchIndex) return;
  const sections = sectionsWith(words);
  for (const section of sections) {
    const link = document.createElement("a");
    link.href = `${base}/${section.location}`;
    link.textContent = section.title;
    const text = document.createElement("p");
    text.textContent = excerpt(section.text, words[0]);
    found.append(link, text);
  }
  if (sections.length === 0) found.textContent = "nothing found";
}

query.addEventListener("focus", loadIndex);
query.addEventListener("input", showResults);
