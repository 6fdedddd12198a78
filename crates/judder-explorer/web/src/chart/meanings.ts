/** Colours, dashes and markers by meaning, written by the tests of `judder-report` from its palette: change them there. */
export const MEANINGS = {
  "areas": {
    "across-slip": "#d9c7a3",
    "both": "#6a4682",
    "convected-slip": "#b5dcf2",
    "destabilised-by-damping": "#6fb09a",
    "flutter": "#5b90c4",
    "knock": "#fbdcd4",
    "knock-unknown": "#f7ece9",
    "lift-off": "#dde9f7",
    "negative-damping": "#eeab55",
    "normal-force-coupling": "#efdc8f",
    "slip-ahead": "#d89fc1",
    "stable": "#f3f3ef",
    "stick": "#b9d9b2",
    "turning-normal": "#e3b7cf",
    "unknown-growth": "#c9c9c9",
    "unresolved": "#8c8c8c",
    "unstable-zone": "#f7dccb",
    "within-law": "#dfdfe6"
  },
  "dashes": {
    "dash-dotted": [
      6.0,
      2.2,
      1.2,
      2.2
    ],
    "dashed": [
      4.5,
      2.5
    ],
    "dotted": [
      1.2,
      2.0
    ],
    "solid": []
  },
  "graded": {
    "end": 0.82,
    "width": 1.35
  },
  "ground": "#ffffff",
  "ink": "#1a1a1a",
  "lines": {
    "conservative-boundary": {
      "colour": "#000000",
      "dash": "dashed",
      "marker": "circle",
      "width": 1.35
    },
    "decoupled-boundary": {
      "colour": "#c8102e",
      "dash": "solid",
      "marker": "circle",
      "width": 1.35
    },
    "full-boundary": {
      "colour": "#000000",
      "dash": "solid",
      "marker": "circle",
      "width": 1.0
    },
    "reference": {
      "colour": "#6b6b6b",
      "dash": "dotted",
      "marker": "circle",
      "width": 0.7
    }
  },
  "quiet": "#6b6b6b",
  "series": {
    "colours": [
      "#0072b2",
      "#d55e00",
      "#009e73",
      "#cc79a7",
      "#56b4e9",
      "#e69f00",
      "#000000"
    ],
    "dashes": [
      "solid",
      "dashed",
      "dash-dotted",
      "dotted"
    ],
    "markers": [
      "circle",
      "square",
      "diamond",
      "triangle",
      "cross"
    ],
    "width": 1.35
  },
  "stops": {
    "diverging": [
      "#2166ac",
      "#4393c3",
      "#92c5de",
      "#d1e5f0",
      "#f7f7f7",
      "#fddbc7",
      "#f4a582",
      "#d6604d",
      "#b2182b"
    ],
    "sequential": [
      "#440154",
      "#472d7b",
      "#3b528b",
      "#2c728e",
      "#21918c",
      "#28ae80",
      "#5ec962",
      "#addc30",
      "#fde725"
    ]
  }
} as const;
