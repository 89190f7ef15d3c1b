// SPDX-License-Identifier: BSD-3-Clause
// Curves over time, by Chart.js.

/** A line at the time of the model above. */
const time_cursor = {
  id: "time_cursor",
  afterDatasetsDraw(chart) {
    const { ctx, chartArea, scales } = chart;
    const time = chart.options.plugins.time_cursor.time;
    if (time === null || time < scales.x.min || time > scales.x.max) return;
    const x = scales.x.getPixelForValue(time);
    ctx.save();
    ctx.strokeStyle = style_colour("--mark");
    ctx.beginPath();
    ctx.moveTo(x, chartArea.top);
    ctx.lineTo(x, chartArea.bottom);
    ctx.stroke();
    ctx.restore();
  },
};

/** Charts of the same title of several runs, joined: [{title, sources, dimension, lines}]. */
function join_charts(runs) {
  const joined = new Map();
  runs.forEach((run, number) => {
    const seen = new Map();
    for (const chart of run.charts) {
      const again = seen.get(chart.title) ?? 0;
      seen.set(chart.title, again + 1);
      const key = `${chart.title} ${again}`;
      if (!joined.has(key)) joined.set(key, { ...chart, sources: [], lines: [] });
      const one = joined.get(key);
      if (chart.source && !one.sources.includes(chart.source)) one.sources.push(chart.source);
      for (const curve of chart.curves) one.lines.push({ ...curve, times: chart.times, number });
    }
  });
  return [...joined.values()];
}

function datasets_of(chart, runs) {
  const names = [...new Set(chart.lines.map((line) => line.name))];
  return chart.lines.map((line) => ({
    label: runs.length > 1 ? `${line.name} · ${runs[line.number].letter}` : line.name,
    data: line.times.map((x, i) => ({ x, y: line.values[i] })),
    borderColor: css_colour(line_colour(names.indexOf(line.name))),
    backgroundColor: css_colour(line_colour(names.indexOf(line.name))),
    borderDash: line.number > 0 ? [6, 3] : [],
    borderWidth: 1.75,
    pointRadius: line.times.length < 3 ? 3 : 0,
    pointHitRadius: 8,
  }));
}

function axis(title) {
  const colour = style_colour("--muted");
  return {
    type: "linear",
    title: { display: Boolean(title), text: title, color: colour },
    grid: { color: style_colour("--grid") },
    ticks: { color: colour, maxRotation: 0, callback: (value) => show_short(value) },
  };
}

/** Of each line its largest size and its last value, in words: what a chart tells those who do not see it. */
function describe_lines(chart, runs) {
  return chart.lines
    .map((line) => {
      const values = line.values.filter((value) => value !== null);
      const peak = values.reduce((a, b) => (Math.abs(b) > Math.abs(a) ? b : a), 0);
      const name = runs.length > 1 ? `${line.name} (${runs[line.number].letter})` : line.name;
      return `${name}: peak ${show_short(peak)}, last ${show_short(values.at(-1))}`;
    })
    .join("; ");
}

/** Makes all charts in a place; returns a function that moves their cursors to a time. */
function show_charts(place, runs) {
  place.replaceChildren();
  const charts = join_charts(runs).map((chart) => show_chart(place, chart, runs));
  if (charts.length === 0) {
    place.append(make("p", { class: "note" }, "No curves: the run has no steps, and there is no heartbeat in CSV."));
  }
  return (time) => {
    for (const chart of charts) {
      chart.options.plugins.time_cursor.time = time;
      chart.draw();
    }
  };
}

function show_chart(place, chart, runs) {
  const words = describe_lines(chart, runs);
  const canvas = make("canvas", { role: "img", "aria-label": `${chart.title} over time. ${words}` });
  const source = chart.sources.length > 0 ? make("span", { class: "source" }, chart.sources.join(", ")) : null;
  place.append(
    make("figure", { class: "chart" }, make("figcaption", {}, chart.title, source),
      make("div", { class: "plot" }, canvas), make("p", { class: "words" }, words)),
  );
  return new Chart(canvas, {
    type: "line",
    data: { datasets: datasets_of(chart, runs) },
    plugins: [time_cursor],
    options: {
      animation: false,
      maintainAspectRatio: false,
      parsing: false,
      interaction: { mode: "nearest", axis: "x", intersect: false },
      scales: { x: { ...axis("time"), max: Math.max(...chart.lines.flatMap((line) => line.times.slice(-1))) },
        y: axis(chart.dimension) },
      plugins: {
        time_cursor: { time: null },
        legend: { labels: { color: style_colour("--text"), boxWidth: 18, boxHeight: 1 } },
        tooltip: { callbacks: { title: (items) => `time ${show_number(items[0].parsed.x)}`,
          label: (item) => `${item.dataset.label}: ${show_number(item.parsed.y)}` } },
      },
    },
  });
}
