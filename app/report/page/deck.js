// SPDX-License-Identifier: BSD-3-Clause
// The deck, coloured by what its words are.

/** The id of a deck line on this page, if the run's deck has it as it is in the file. */
function line_id(run, file, line) {
  const index = run.deck.files.findIndex((one) => one.name === file);
  return index < 0 || run.deck.expanded ? null : `deck-${run.number}-${index}-${line}`;
}

function deck_line(run, file, line) {
  const found = run.deck.files.find((one) => one.name === file);
  return found && !run.deck.expanded ? found.text.split("\n")[line - 1] : undefined;
}

const deck_words = new RegExp(
  [
    "(?<comment>[#$].*$)",
    "(?<aprepro>\\{[^}]*\\})",
    '(?<text>"[^"]*"|\'[^\']*\')',
    "(?<block>\\b(?:begin|end)\\b.*?(?=[#${]|$))",
    "(?<number>(?<![\\w.])[-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[edED][-+]?\\d+)?(?![\\w.]))",
    "(?<sign>=|\\b(?:is|are)\\b)",
  ].join("|"),
  "gi",
);

/** A line's pieces, those that mean something in spans. */
function highlight(line) {
  const pieces = [];
  let at = 0;
  for (const found of line.matchAll(deck_words)) {
    if (found.index > at) pieces.push(line.slice(at, found.index));
    const [kind] = Object.entries(found.groups).find(([, text]) => text !== undefined);
    pieces.push(make("span", { class: kind }, found[0]));
    at = found.index + found[0].length;
  }
  pieces.push(line.slice(at));
  return pieces;
}

function show_file(run, file, index) {
  const marked = new Map();
  for (const problem of problems_of(run)) {
    for (const place of problem.places) {
      if (place.file === file.name && !run.deck.expanded) marked.set(place.line, problem.severity);
    }
  }
  const lines = file.text.replace(/\n$/, "").split("\n").map((text, i) =>
    make("li", { id: `deck-${run.number}-${index}-${i + 1}`, class: marked.get(i + 1) },
      make("code", {}, ...highlight(text.replace(/\r$/, "")))));
  return make("details", { open: index === 0 && run.number === 0 }, make("summary", {}, file.name),
    make("ol", { class: "deck", tabindex: "0", "aria-label": file.name }, ...lines));
}

function show_deck(place, runs) {
  for (const run of runs) {
    if (runs.length > 1) place.append(make("h3", {}, `${run.letter}: ${run.name}`));
    if (run.deck.files.length === 0) place.append(make("p", { class: "note" }, "The deck is not known."));
    if (run.deck.expanded) {
      place.append(make("p", { class: "note" }, "This is what Aprepro made of the deck, as the run stored it: ",
        "includes are in, and its lines are not those of the file."));
    }
    run.deck.files.forEach((file, index) => place.append(show_file(run, file, index)));
  }
  open_target();
  window.addEventListener("hashchange", open_target);
}

/** A link into a closed file opens it. */
function open_target() {
  const line = location.hash.startsWith("#deck-") ? document.getElementById(location.hash.slice(1)) : null;
  if (!line) return;
  line.closest("details").open = true;
  line.scrollIntoView({ block: "center" });
}
