// A section through the box, pixel by pixel.
import { element } from "./dom.js";

// Colours of a pixel: 255 is grain; else 254 times the saturation, from orange (air) over sand to blue (water).
export const air = [243, 156, 44], half = [214, 205, 170], water = [31, 95, 168], grain = [245, 247, 249];
const colour = (s, c) => (s < 0.5 ? air[c] + 2 * s * (half[c] - air[c]) : half[c] + (2 * s - 1) * (water[c] - half[c]));

/** Draws a picture of the given columns and rows into a canvas. */
export function paint(canvas, { columns, rows }, picture) {
  const bytes = Uint8Array.from(atob(picture), (c) => c.charCodeAt(0));
  canvas.width = columns;
  canvas.height = rows;
  const context = canvas.getContext("2d"), image = context.createImageData(columns, rows);
  for (let row = 0; row < rows; ++row)
    for (let column = 0; column < columns; ++column) {
      const byte = bytes[row * columns + column], at = 4 * ((rows - 1 - row) * columns + column);
      for (let c = 0; c < 3; ++c) image.data[at + c] = byte === 255 ? grain[c] : colour(byte / 254, c);
      image.data[at + 3] = 255;
    }
  context.putImageData(image, 0, 0);
}

/** A word of the key, beside its colour. */
export const swatch = (colour, text) => element("span", { class: "key" }, element("i", { style: `background: rgb(${colour})` }), ` ${text}`);
