// The picture: marks as the elements that svg.py writes.

const MARGIN = 32;
const NARROW = 460;
const SAMPLES = 97;
const STEEP = 0.66;
const BELOW = 20;
const AWAY = 24;

function layout(width, [x0, y0, x1, y1], beside, size, stretched, line) {
  const margin = MARGIN * size;
  const stacked = line || width < NARROW;
  const across = stacked || !beside ? width : Math.round(0.62 * width);
  const steep = stretched ? STEEP : (y1 - y0) / (x1 - x0);
  const high = line ? 0.5 : 0.72;
  const height = Math.round(Math.min(Math.max(steep * (across - 2 * margin) + 2 * margin, 0.4 * across), high * across));
  const first = [0, 0, across, height];
  if (!beside) return [height, [first]];
  const under = Math.round((line ? 0.36 : 0.7) * width);
  if (stacked) return [height + under, [first, [0, height, width, under]]];
  return [height, [first, [across, 0, width - across, height]]];
}

function frameOf([left, top, width, height], [x0, y0, x1, y1], size, stretched = false) {
  const margin = MARGIN * size;
  const scales = [(width - 2 * margin) / (x1 - x0), (height - 2 * margin) / (y1 - y0)];
  const scale = stretched ? scales : [Math.min(...scales), Math.min(...scales)];
  const x = left + width / 2 - (scale[0] * (x0 + x1)) / 2;
  const y = top + height / 2 + (scale[1] * (y0 + y1)) / 2;
  return {
    rectangle: [left, top, width, height],
    place: ([px, py]) => [x + scale[0] * px, y - scale[1] * py],
    back: ([sx, sy]) => [(sx - x) / scale[0], (y - sy) / scale[1]],
    diagonal: Math.hypot(width, height),
  };
}

function vectorView(marks) {
  const reach = Math.max(0, ...marks.filter((m) => m.frame && m.kind !== "whole").flatMap((m) => m.points.flat()).map(Math.abs));
  const half = reach > 0 ? 2 ** Math.ceil(Math.log2(reach)) : 1;
  return [-half, -half, half, half];
}

const STRAIGHT = 1e-6;

function outward(here, neighbours) {
  const ways = neighbours.map((there) => subtract(there, here)).filter(([x, y]) => x || y);
  const units = ways.map((way) => way.map((c) => c / Math.hypot(...way)));
  const bisector = [0, 1].map((axis) => -units.reduce((sum, unit) => sum + unit[axis], 0));
  const length = Math.hypot(...bisector);
  if (length > STRAIGHT) return bisector.map((c) => c / length);
  const [x, y] = units[0] ?? [1, 0];
  return x > STRAIGHT || (Math.abs(x) <= STRAIGHT && y > 0) ? [y, -x] : [-y, x]; // pixels count downwards
}

const beside = (pixels, size) =>
  pixels.map((dot, i) => together(dot, outward(dot, [pixels[i - 1], pixels[i + 1]].filter(Boolean)), AWAY * size));

// Names of a line's two points: across it, on the other side where a control point or its name is in the way.
function acrossLine([p, q], taken, size) {
  const room = (at) => Math.min(...taken.map((other) => Math.hypot(...subtract(at, other))));
  return [[p, q], [q, p]].map(([end, other]) => {
    const across = outward(end, [other, together(end, subtract(end, other), 1)]);
    const [one, opposite] = [1, -1].map((side) => together(end, across, side * AWAY * size));
    return room(one) < AWAY * size && room(opposite) > room(one) ? opposite : one;
  });
}

const rounded = (x) => x.toFixed(1);
const escaped = (text) => text.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);

function drawn(m, frame, styles, size) {
  const style = typeof m.style === "string" ? styles[m.style] : m.style;
  let pixels = m.points.map(frame.place);
  if (m.kind === "curve")
    pixels = Array.from({ length: SAMPLES }, (_, i) => frame.place(pointAt(m.points, i / (SAMPLES - 1))));
  if (m.kind === "whole") {
    const along = subtract(pixels[1], pixels[0]);
    const reach = along.map((c) => (2 * frame.diagonal * c) / Math.hypot(...along));
    pixels = [subtract(pixels[0], reach), [pixels[0][0] + reach[0], pixels[0][1] + reach[1]]];
  }
  const look = (fill, dashed = true) => ({
    fill: fill === "none" ? fill : `var(--bt-${fill})`,
    "fill-opacity": style.opacity,
    stroke: `var(--bt-${style.colour})`,
    "stroke-width": style.width * size,
    ...(dashed && style.dash ? { "stroke-dasharray": style.dash } : {}),
  });
  const path = (tag, fill) => [tag, { points: pixels.map((p) => p.map(rounded).join()).join(" "), ...look(fill), "stroke-linejoin": "round" }]; // prettier-ignore
  const dot = ([x, y], r, fill, dashed) => ["circle", { cx: rounded(x), cy: rounded(y), r: rounded(r), ...look(fill, dashed) }];
  const r = style.radius * size;
  const square = ([x, y]) => ["rect", { x: rounded(x - r), y: rounded(y - r), width: 2 * r, height: 2 * r, ...look(style.fill, false) }];
  switch (m.kind) {
    case "area":
      return [path("polygon", style.fill)];
    case "circle":
      return [dot(pixels[0], Math.hypot(...subtract(pixels[1], pixels[0])), "none", true)];
    case "dots":
      return pixels.map((p) => dot(p, r, style.fill, false));
    case "squares":
      return pixels.map(square);
    case "names":
    case "below": {
      const places = m.kind === "below" ? pixels.map(([x, y]) => [x, y + BELOW * size]) : beside(pixels, size);
      return places.map((at, i) => word(at, m.words[i], size));
    }
    default:
      return [path("polyline", "none")];
  }
}

const word = ([x, y], text, size) => ["text", { x: rounded(x), y: rounded(y + 6 * size), "text-anchor": "middle" }, text];

// Elements, as [tag, attributes, text or elements], on the screen. What stays is not made anew, nor set again: the
// browser would hold it against every style of the page, and lay it out.
function put(parent, wanted) {
  wanted.forEach(([tag, attributes, inside = ""], i) => {
    let node = parent.children[i];
    if (node?.tagName !== tag) {
      const made = document.createElementNS(SVG, tag);
      if (node) node.replaceWith(made);
      else parent.append(made);
      node = made;
    }
    const old = node.told ?? {};
    for (const name in attributes) if (old[name] !== attributes[name]) node.setAttribute(name, attributes[name]);
    for (const name in old) if (!(name in attributes)) node.removeAttribute(name);
    node.told = attributes;
    if (Array.isArray(inside)) put(node, inside);
    else if (node.textContent !== inside) node.textContent = inside;
  });
  while (parent.children.length > wanted.length) parent.lastChild.remove();
}
