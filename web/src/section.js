// A section through the box, pixel by pixel.
import { element } from "./dom.js";

// Colours of a pixel: 255 is grain; else 254 times the saturation, from orange (air) over sand to blue (water).
export const air = [243, 156, 44], half = [214, 205, 170], water = [31, 95, 168], grain = [245, 247, 249];
/** Colour at a share from low over middle to high. */
export const ramp = (low, middle, high, share) => low.map((_, c) => (share < 0.5 ? low[c] + 2 * share * (middle[c] - low[c]) : middle[c] + (2 * share - 1) * (high[c] - middle[c])));

/** Draws a picture of the given columns and rows into a canvas. */
export function paint(canvas, { columns, rows }, picture) {
  const bytes = Uint8Array.from(atob(picture), (c) => c.charCodeAt(0));
  canvas.width = columns;
  canvas.height = rows;
  const context = canvas.getContext("2d"), image = context.createImageData(columns, rows);
  for (let row = 0; row < rows; ++row)
    for (let column = 0; column < columns; ++column) {
      const byte = bytes[row * columns + column], at = 4 * ((rows - 1 - row) * columns + column);
      image.data.set(byte === 255 ? grain : ramp(air, half, water, byte / 254), at);
      image.data[at + 3] = 255;
    }
  context.putImageData(image, 0, 0);
}

/** Arrows at the grains of a picture, along the given parts of a vector; the longest is two cells of a grid of 14. */
export function arrows(canvas, picture, across, up, longest) {
  const context = canvas.getContext("2d"), scale = (2 / 14) * picture.columns / longest;
  context.strokeStyle = context.fillStyle = "#1a2330";
  context.lineWidth = 0.9;
  picture.across.forEach((x, k) => {
    const from = [x / picture.pixel, picture.rows - picture.up[k] / picture.pixel];
    const way = [across[k] * scale, -up[k] * scale], size = Math.hypot(...way);
    if (size < 1.5) return;
    const to = [from[0] + way[0], from[1] + way[1]], head = Math.min(4, 0.4 * size), angle = Math.atan2(way[1], way[0]);
    context.beginPath();
    context.moveTo(...from);
    context.lineTo(...to);
    context.stroke();
    context.beginPath();
    context.moveTo(...to);
    for (const turn of [2.65, -2.65]) context.lineTo(to[0] + head * Math.cos(angle + turn), to[1] + head * Math.sin(angle + turn));
    context.fill();
  });
}

/** A word of the key, beside its colour. */
export const swatch = (colour, text) => element("span", { class: "key" }, element("i", { style: `background: rgb(${colour})` }), ` ${text}`);
