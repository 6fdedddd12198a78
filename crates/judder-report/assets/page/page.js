// Turns each drawing into an interactive chart when it comes near the screen.
"use strict";
(function () {
  const narrow = window.matchMedia("(max-width: 700px)");
  // plotly's button that uploads a chart has no place on a page that stays on its reader's machine
  const config = {
    responsive: true,
    displaylogo: false,
    plotlyServerURL: "",
    modeBarButtonsToRemove: ["sendChartToCloud", "sendDataToCloud", "select2d", "lasso2d", "autoScale2d"],
  };

  // an array that several traces have stands in the first of them
  function findArrays(trace, _index, traces) {
    for (const key of ["x", "y", "customdata"]) {
      const same = trace[key] && trace[key].same;
      if (same) trace[key] = traces[same[0]][same[1]];
    }
  }

  // a class map carries runs of codes; the names of codes are shared strings, so a large map costs little
  function unrollClasses(trace) {
    const classes = trace.meta && trace.meta.classes;
    if (!classes) return;
    const [rows, columns] = trace.z.shape.split(",").map(Number);
    const runs = Uint8Array.from(atob(trace.z.runs), (character) => character.charCodeAt(0));
    const codes = new Uint8Array(rows * columns);
    for (let run = 0, start = 0; run < runs.length; run += 3) {
      const end = start + runs[run + 1] + 256 * runs[run + 2];
      codes.fill(runs[run], start, end);
      start = end;
    }
    trace.z = [];
    trace.text = [];
    for (let start = 0; start < codes.length; start += columns) {
      const row = codes.subarray(start, start + columns);
      trace.z.push(row);
      trace.text.push(Array.from(row, (code) => classes[code]));
    }
  }

  // numbers of a typed array, little-endian as the page wrote them
  function numbers(array) {
    const bytes = Uint8Array.from(atob(array.bdata), (character) => character.charCodeAt(0));
    const view = new DataView(bytes.buffer);
    return Array.from({ length: bytes.length / 8 }, (_, index) => view.getFloat64(8 * index, true));
  }

  // the frames of one period of all swinging lines, and the buttons that show them
  const phases = 24;
  const periods = 20;
  function makeFrames(chart) {
    const traces = chart.data.flatMap((trace, index) => (trace.meta && trace.meta.swing ? [index] : []));
    if (traces.length === 0) return [];
    const swings = traces.map((index) => {
      const trace = chart.data[index];
      return ["x", "y"].map((axis) => [numbers(trace[axis]), ...trace.meta.swing[axis].map(numbers)]);
    });
    const at = (phase) => ([drawn, real, imaginary]) =>
      drawn.map((value, k) => value + real[k] * (Math.cos(phase) - 1) - imaginary[k] * Math.sin(phase));
    const frames = Array.from({ length: phases }, (_, number) => {
      const [x, y] = [0, 1].map((axis) => swings.map((swing) => at((2 * Math.PI * number) / phases)(swing[axis])));
      return { name: String(number), traces, data: traces.map((_, k) => ({ x: x[k], y: y[k] })) };
    });
    const names = Array.from({ length: phases * periods + 1 }, (_, number) => String(number % phases));
    const show = (frames, duration) => [frames, {
      mode: "immediate", frame: { duration, redraw: false }, transition: { duration: 0 },
    }];
    const buttons = [
      { label: "Swing", method: "animate", args: show(names, 60) },
      { label: "Stop", method: "animate", args: show(["0"], 0) },
    ];
    for (const layout of [chart.layout, chart.narrow]) {
      layout.updatemenus = [{
        type: "buttons", direction: "left", showactive: false, buttons, x: 1, xanchor: "right", y: 1, yanchor: "bottom",
        pad: { b: 4, r: 0 }, font: { size: 11.5 }, bgcolor: "#ffffff",
      }];
    }
    return frames;
  }

  // the fixed decades suit the first view; inside two of them, or beyond the first view, plotly's own ticks do
  function fitTicks(live, layout) {
    const changes = {};
    for (const name of Object.keys(layout).filter((key) => /^[xy]axis/.test(key) && layout[key].type === "log")) {
      const [from, to] = live.layout[name].range;
      const [first, last] = layout[name].range;
      const suits = to - from >= Math.min(2, last - first) - 0.01 && from >= first - 0.01 && to <= last + 0.01;
      const mode = suits ? "array" : "auto";
      if (live.layout[name].tickmode !== mode) {
        changes[name + ".tickmode"] = mode;
        changes[name + ".minor.tickmode"] = mode;
      }
    }
    if (Object.keys(changes).length > 0) Plotly.relayout(live, changes);
  }

  function draw(figure) {
    const still = figure.querySelector(".still");
    const live = figure.querySelector(".live");
    const chart = JSON.parse(figure.querySelector("script").textContent);
    chart.data.forEach(findArrays);
    chart.data.forEach(unrollClasses);
    const frames = makeFrames(chart);
    // plotly writes into its layout, so each view gets a copy
    const arrangement = () => structuredClone(narrow.matches ? chart.narrow : chart.layout);
    live.hidden = false;
    Plotly.newPlot(live, { data: chart.data, layout: arrangement(), config, frames }).then(
      () => {
        still.classList.add("replaced");
        narrow.addEventListener("change", () => Plotly.react(live, chart.data, arrangement(), config));
        live.on("plotly_relayout", () => fitTicks(live, chart.layout));
      },
      () => { live.hidden = true; },
    );
  }

  const figures = document.querySelectorAll("[data-plot]");
  if (!("IntersectionObserver" in window)) {
    figures.forEach(draw);
    return;
  }
  const near = new IntersectionObserver((entries) => {
    for (const entry of entries.filter((entry) => entry.isIntersecting)) {
      near.unobserve(entry.target);
      draw(entry.target);
    }
  }, { rootMargin: "600px" });
  figures.forEach((figure) => near.observe(figure));
})();
