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

  // a class map carries codes; their names are shared strings, so a large map costs little
  function nameClasses(trace) {
    const classes = trace.meta && trace.meta.classes;
    if (!classes) return;
    const columns = Number(trace.z.shape.split(",")[1]);
    const codes = Uint8Array.from(atob(trace.z.bdata), (character) => character.charCodeAt(0));
    trace.text = [];
    for (let start = 0; start < codes.length; start += columns) {
      trace.text.push(Array.from(codes.subarray(start, start + columns), (code) => classes[code]));
    }
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
    chart.data.forEach(nameClasses);
    // plotly writes into its layout, so each view gets a copy
    const arrangement = () => structuredClone(narrow.matches ? chart.narrow : chart.layout);
    live.hidden = false;
    Plotly.newPlot(live, chart.data, arrangement(), config).then(
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
