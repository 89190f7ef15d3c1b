// SPDX-License-Identifier: BSD-3-Clause
// Colours by lightness, chroma and hue, in which equal steps look equal.

/** OKLCH to sRGB, each 0 to 255. Source: Ottosson, A perceptual color space for image processing (2020). */
function rgb_of(lightness, chroma, hue) {
  const a = chroma * Math.cos((hue * Math.PI) / 180);
  const b = chroma * Math.sin((hue * Math.PI) / 180);
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  const linear = [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
  return linear.map((x) => {
    const c = Math.min(1, Math.max(0, x));
    return Math.round(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055));
  });
}

const no_colour = [150, 154, 160];

/** The colour of the i-th of things that differ in kind: hues far apart, two lightnesses. */
function kind_colour(i) {
  return rgb_of(i % 2 ? 0.78 : 0.62, 0.13, (255 + 137.5 * i) % 360);
}

/** The same for thin lines, which the ground, light or dark, must not swallow. */
function line_colour(i) {
  return rgb_of(matchMedia("(prefers-color-scheme: dark)").matches ? 0.76 : 0.54, 0.15, (255 + 137.5 * i) % 360);
}

/** 256 colours from dark blue to light yellow. */
const scale_colours = Array.from({ length: 256 }, (_, i) => {
  const t = i / 255;
  return rgb_of(0.34 + 0.58 * t, 0.1 + 0.07 * Math.sin(Math.PI * t), 275 - 175 * t);
});

function css_colour([r, g, b]) {
  return `rgb(${r} ${g} ${b})`;
}

/** The scale as a background, from left to right. */
function scale_gradient() {
  const stops = [0, 51, 102, 153, 204, 255].map((i) => css_colour(scale_colours[i]));
  return `linear-gradient(to right, ${stops.join(", ")})`;
}

/** A colour of the style sheet, which knows of the dark. */
function style_colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}
