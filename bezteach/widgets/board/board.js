// The board in a browser: it paints the layers of a state at once and moves its points; Python answers with exact
// numbers. Sections: exact numbers; the scene, as in scene.py; the picture, as in svg.py; what the reader moves.

// ---- Exact numbers: a fraction is [p, q] in BigInt, with q > 0 and nothing to cancel ----

const gcd = (a, b) => (b ? gcd(b, a % b) : a < 0n ? -a : a);
const fraction = (p, q = 1n) => {
  const common = gcd(p, q) * (q < 0n ? -1n : 1n);
  return [p / common, q / common];
};
const read = (text) => fraction(...String(text).split("/").map(BigInt));
const write = ([p, q]) => (q === 1n ? `${p}` : `${p}/${q}`);
const plus = ([a, b], [c, d]) => fraction(a * d + c * b, b * d);
const times = ([a, b], [c, d]) => fraction(a * c, b * d);
const minus = (x, y) => plus(x, times([-1n, 1n], y));
const value = (text) => {
  const [p, q] = read(text);
  return Number(p) / Number(q);
};
const mix = (x, y, t) => plus(times(minus([1n, 1n], t), x), times(t, y));
const mixed = (p, q, t) => p.map((text, axis) => write(mix(read(text), read(q[axis]), t)));

export function elevated(points) {
  const n = points.length;
  return Array.from({ length: n + 1 }, (_, j) =>
    mixed(points[Math.min(j, n - 1)], points[Math.max(j - 1, 0)], fraction(BigInt(j), BigInt(n))),
  );
}

export function exactLevels(points, t) {
  const levels = [points];
  while (levels.at(-1).length > 1) {
    const level = levels.at(-1);
    levels.push(level.slice(1).map((q, j) => mixed(level[j], q, read(t))));
  }
  return levels;
}

// ---- The scene: each layer's marks from floats, in the order and the shape of scene.py ----

const SUBSCRIPTS = "₀₁₂₃₄₅₆₇₈₉";
const ROUNDING = 1e-12; // what is smaller, relatively, is 0: Python decides it exactly
const between = (p, q, t) => p.map((c, axis) => (1 - t) * c + t * q[axis]);
const subtract = (p, q) => [p[0] - q[0], p[1] - q[1]];
const cross = (p, q) => p[0] * q[1] - p[1] * q[0];
const floats = (points) => points.map((point) => point.map(value));

function levelsAt(points, t) {
  const levels = [points];
  while (levels.at(-1).length > 1) {
    const level = levels.at(-1);
    levels.push(level.slice(1).map((q, j) => between(level[j], q, t)));
  }
  return levels;
}

const pointAt = (points, t) => levelsAt(points, t).at(-1)[0];

function split(points, t) {
  const levels = levelsAt(points, t);
  return [levels.map((level) => level[0]), levels.map((level) => level.at(-1)).reverse()];
}

const segment = (points, a, b) =>
  points.map((_, j) => {
    let level = points;
    for (let step = 1; step < points.length; step++) {
      const at = step <= j ? b : a;
      level = level.slice(1).map((q, k) => between(level[k], q, at));
    }
    return level[0];
  });

const arrowsOf = (points) =>
  points.slice(1).map((q, i) => subtract(q, points[i]).map((c) => c * (points.length - 1)));

const raise = (points) =>
  Array.from({ length: points.length + 1 }, (_, j) =>
    between(points[Math.min(j, points.length - 1)], points[Math.max(j - 1, 0)], j / points.length),
  );

function halved(points, depth) {
  let pieces = [points];
  for (let k = 0; k < depth; k++) pieces = pieces.flatMap((piece) => split(piece, 0.5));
  return pieces;
}

function hull(points) {
  const ordered = [...new Map(points.map((p) => [p.join(), p])).values()].sort((p, q) => p[0] - q[0] || p[1] - q[1]);
  if (ordered.length < 3) return ordered;
  const chain = (list) => {
    const corners = [];
    for (const point of list) {
      while (corners.length > 1 && cross(subtract(corners.at(-1), corners.at(-2)), subtract(point, corners.at(-2))) <= 0)
        corners.pop();
      corners.push(point);
    }
    return corners.slice(0, -1);
  };
  return [...chain(ordered), ...chain([...ordered].reverse())];
}

function endCircle(points) {
  const first = subtract(points[1], points[0]);
  const n = points.length - 1;
  const second = subtract(points[Math.min(2, n)], points[0]);
  const area = cross(first, second);
  if (Math.abs(area) <= ROUNDING * Math.hypot(...first) * Math.hypot(...second)) return null;
  const away = (n * (first[0] ** 2 + first[1] ** 2)) / ((n - 1) * area);
  return [[points[0][0] - away * first[1], points[0][1] + away * first[0]], points[0]];
}

const heights = (points, [p, q]) => points.map((b) => cross(subtract(q, p), subtract(b, p)));

function polygonCrossings(points, line) {
  const h = heights(points, line);
  const size = Math.max(...h.map(Math.abs));
  const sign = h.map((x) => (Math.abs(x) <= ROUNDING * size ? 0 : Math.sign(x)));
  if (!sign.some(Boolean)) return [];
  const places = points.filter((_, i) => sign[i] === 0 && (i === 0 || sign[i - 1] !== 0));
  const edges = points.map((_, i) => i).filter((i) => sign[i] * sign[i + 1] < 0);
  return [...places, ...edges.map((i) => between(points[i], points[i + 1], h[i] / (h[i] - h[i + 1])))];
}

const TINY = 1e-9;
const NEAR = 1e-3;
const DEPTH = 20;

function curveCrossings(points, line) {
  const h = heights(points, line);
  const size = Math.max(...h.map(Math.abs));
  if (size === 0) return [];
  const found = [];
  const search = (piece, low, high) => {
    if (piece.every(([x]) => x > TINY) || piece.every(([x]) => x < -TINY)) return;
    if (piece.every(([x]) => Math.abs(x) <= TINY) || high - low < 2 ** -DEPTH) {
      const t = (low + high) / 2;
      if (!found.length || t - found.at(-1) > NEAR) found.push(t);
      return;
    }
    const [left, right] = split(piece, 0.5);
    search(left, low, (low + high) / 2);
    search(right, (low + high) / 2, high);
  };
  search(
    h.map((x) => [x / size]),
    0,
    1,
  );
  return found.map((t) => pointAt(points, t));
}

const together = (p, q, factor) => [p[0] + factor * q[0], p[1] + factor * q[1]];

const cutInPieces = (points) =>
  Array.from({ length: Math.ceil((points.length - 1) / 3) }, (_, k) => points.slice(3 * k, 3 * k + 4));

function aFrame(left, right, [h, l]) {
  if (left.length !== 4 || right.length !== 4 || !(h * l)) return null;
  const [before, after] = [subtract(left[2], left[1]), subtract(right[1], right[2])];
  return [together(left[2], before, l / h), together(right[1], after, h / l)];
}

const cubics = (data, thirds) =>
  data.slice(1).map((end, i) => [data[i], together(data[i], thirds[i], 1), together(end, thirds[i + 1], -1), end]);

function catmullRom(data) {
  const beyond = (end, inner) => together(end, subtract(end, inner), 1);
  const longer = [beyond(data[0], data[1]), ...data, beyond(data.at(-1), data.at(-2))];
  return cubics(data, data.map((_, i) => subtract(longer[i + 2], longer[i]).map((c) => c / 6))); // prettier-ignore
}

function natural(data) {
  const last = data.length - 1;
  const v = data.map((_, i) => subtract(data[Math.min(i + 1, last)], data[Math.max(i - 1, 0)]).map((c) => 3 * c));
  const pivots = [2];
  for (let i = 1; i <= last; i++) {
    v[i] = together(v[i], v[i - 1], -1 / pivots[i - 1]);
    pivots.push((i < last ? 4 : 2) - 1 / pivots[i - 1]);
  }
  for (let i = last; i >= 0; i--) v[i] = (i < last ? subtract(v[i], v[i + 1]) : v[i]).map((c) => c / pivots[i]);
  return cubics(data, v.map((vector) => vector.map((c) => c / 3))); // prettier-ignore
}

const mark = (kind, points, style, frame = 0) => ({ kind, points, style, frame });
const same = (p, q, size) => Math.hypot(...subtract(p, q)) <= ROUNDING * size;
const parity = (i) => (i % 2 ? "odd" : "even");

const PAINTED = {
  hull(points) {
    const [xs, ys] = [0, 1].map((axis) => points.map((p) => p[axis]));
    const [x0, y0, x1, y1] = [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
    const corners = [[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]]; // prettier-ignore
    return [mark("area", hull(points), "hull"), mark("line", corners, "box")];
  },
  polygon: (points) => [mark("line", points, "polygon")],
  curve: (points) => [mark("curve", points, "curve")],
  elevated(points, state) {
    const marks = [];
    for (let r = 1, raised = raise(points); r <= state.raised; r++, raised = raise(raised))
      marks.push(mark("line", raised, parity(r)), mark("dots", raised, parity(r)));
    return marks;
  },
  halving: (points, state) =>
    halved(points, state.depth).flatMap((piece, i) => [mark("line", piece, parity(i)), mark("dots", piece, parity(i))]),
  circle(points, state) {
    const found = endCircle(state.end ? [...points].reverse() : points);
    return found ? [mark("circle", found, "circle"), mark("line", found, "axis"), mark("dots", found, "new")] : [];
  },
  point: (points, state) => [mark("dots", [pointAt(points, value(state.t))], "point")],
  tangents(points, state) {
    const levels = levelsAt(points, value(state.t));
    const size = Math.max(...points.flat().map(Math.abs));
    const pairs = [points.slice(0, 2), levels.at(-2), points.slice(-2)].filter(([p, q]) => !same(p, q, size));
    return [...pairs.map((pair) => mark("whole", pair, "tangent")), mark("dots", levels.at(-1), "point")];
  },
  line(points, state) {
    const line = floats(state.line);
    const crossings = [
      mark("squares", polygonCrossings(points, line), "polygon-crossing"),
      mark("dots", curveCrossings(points, line), "crossing"),
    ];
    return [mark("whole", line, "line"), ...crossings.filter((found) => found.points.length)];
  },
  levels(points, state) {
    const last = state.level === null ? points.length - 1 : state.level;
    const levels = levelsAt(points, value(state.t)).slice(1, last + 1);
    return [
      ...levels.filter((level) => level.length > 1).map((level) => mark("line", level, "level")),
      ...levels.map((level) => mark("dots", level, level.length > 1 ? "new" : "point")),
    ];
  },
  halves(points, state) {
    const [left, right] = split(points, value(state.t));
    return [
      mark("curve", left, "left-curve"),
      mark("curve", right, "right-curve"),
      mark("line", left, "left"),
      mark("line", right, "right"),
      mark("dots", left, "left"),
      mark("squares", right, "right"),
    ];
  },
  part(points, state) {
    const part = segment(points, value(state.a), value(state.b));
    return [mark("curve", part, "part"), mark("line", part, "right"), mark("squares", part, "right")];
  },
  hodograph(points, state) {
    const arrows = arrowsOf(points);
    const t = value(state.t);
    const tip = pointAt(arrows, t);
    return [
      mark("whole", [[0, 0], [1, 0]], "axis", 1), // prettier-ignore
      mark("whole", [[0, 0], [0, 1]], "axis", 1), // prettier-ignore
      mark("line", arrows, "polygon", 1),
      mark("curve", arrows, "hodograph", 1),
      mark("dots", arrows, "new", 1),
      mark("line", [[0, 0], tip], "vector", 1),
      mark("dots", [tip], "point", 1),
      { ...mark("names", [tip], "point", 1), words: ["p′(t)"] },
      mark("dots", [pointAt(points, t)], "point"),
    ];
  },
  pieces: (points) => cutInPieces(points).map((piece, k) => mark("curve", piece, k % 2 ? "right-curve" : "left-curve")),
  frames(points, state) {
    const t = value(state.t);
    const pieces = cutInPieces(points);
    return pieces.slice(1).flatMap((right, k) => {
      const tips = aFrame(pieces[k], right, k % 2 ? [1 - t, t] : [t, 1 - t]);
      if (!tips) return [];
      const legs = [mark("line", [pieces[k][2], tips[0]], "left"), mark("line", [right[1], tips[1]], "right")];
      return [...legs, mark("squares", [tips[1]], "right"), mark("dots", [tips[0]], "new")];
    });
  },
  local: (points) => spline(catmullRom(points), "left-curve", "odd"),
  natural: (points) => spline(natural(points), "right-curve", "even"),
};

function spline(cubics, curve, inner) {
  const curves = cubics.map((cubic) => mark("curve", cubic, curve));
  return [...curves, ...cubics.flatMap((cubic) => [mark("line", cubic, inner), mark("dots", cubic.slice(1, 3), inner)])];
}

export function scene(state) {
  const points = floats(state.points);
  return Object.keys(PAINTED)
    .filter((name) => state.show.includes(name))
    .flatMap((name) => PAINTED[name](points, state));
}

const nameOf = (letter, i) => letter + String(i).replace(/\d/g, (digit) => SUBSCRIPTS[digit]);

// ---- The picture: marks as the elements that svg.py writes ----

const MARGIN = 32;
const NARROW = 460;
const SAMPLES = 97;
const STEEP = 0.66;
const BELOW = 20;
const AWAY = 24;

function layout(width, [x0, y0, x1, y1], beside, size, stretched) {
  const margin = MARGIN * size;
  const across = width < NARROW || !beside ? width : Math.round(0.62 * width);
  const steep = stretched ? STEEP : (y1 - y0) / (x1 - x0);
  const height = Math.round(Math.min(Math.max(steep * (across - 2 * margin) + 2 * margin, 0.4 * across), 0.72 * across));
  const first = [0, 0, across, height];
  if (!beside) return [height, [first]];
  const below = Math.round(0.7 * width);
  if (width < NARROW) return [height + below, [first, [0, height, width, below]]];
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

// ---- What the reader moves ----

const element = (tag, attributes = {}, ...children) => {
  const made = document.createElement(tag);
  for (const [name, set] of Object.entries(attributes)) {
    if (name.startsWith("on")) made.addEventListener(name.slice(2), set);
    else if (set !== false) made.setAttribute(name, set === true ? "" : set);
  }
  made.append(...children);
  return made;
};

const SVG = "http://www.w3.org/2000/svg";
const NARROWEST = 240; // pixels of a picture
const REACH = 26; // pixels around a point in which a finger or a pointer takes it
const BIG = 5n; // grid steps of an arrow key with Shift
const TICKS = 120; // of t while it plays; the slider stops at every fifth
const SECONDS = 5;
const REMEMBERED = 200;
const ARROWS = { ArrowLeft: [-1n, 0n], ArrowRight: [1n, 0n], ArrowUp: [0n, 1n], ArrowDown: [0n, -1n] };

function render({ model, el }) {
  let state = model.get("state");
  let selected = null;
  let playing = null;
  let frame = null;
  let held = null;
  let history = [];
  let width = 640;
  let own = JSON.stringify(model.get("answer").marks); // what Python wants painted under the layers
  const styles = model.get("styles");
  const size = () => (model.get("projector") ? 1.6 : 1);
  const grid = () => read(model.get("grid"));
  const most = model.get("most");

  // -- the parts on the screen
  const svg = document.createElementNS(SVG, "svg");
  put(svg, [["g", { "aria-hidden": "true" }], ["g", {}]]); // prettier-ignore
  const [under, above] = svg.children;
  svg.setAttribute("role", "group");
  const readout = element("div", { class: "bt-readout" });
  const said = element("div", { class: "bt-said", "aria-live": "polite" });
  const sliders = element("div", { class: "bt-row" });
  const tools = element("div", { class: "bt-row", role: "toolbar", "aria-label": "change the board" });
  const picture = element("div", { class: "bt-picture" }, svg);
  const root = element("div", { class: "bt-board" }, sliders, element("div", { class: "bt-both" }, picture, readout), tools, said);
  el.append(root);

  // -- state
  const send = () =>
    queueMicrotask(() => { // the picture first
      model.set("state", state);
      model.save_changes();
    }); // prettier-ignore
  const remember = () => {
    history.push(state);
    history = history.slice(-REMEMBERED);
  };
  const become = (changes, { recorded = true } = {}) => {
    const next = { ...state, ...changes };
    if (JSON.stringify(next) === JSON.stringify(state)) return;
    if (recorded) remember();
    state = next;
    paint();
    send();
  };
  const undo = () => {
    if (!history.length) return;
    state = history.pop();
    paint();
    send();
  };

  // -- moving points: a handle is a control point or one of the line's two
  const handles = () => [
    ...state.points.map((at, index) => ({ at, list: "points", index, name: nameOf(model.get("letter"), index) })),
    ...(state.show.includes("line") ? state.line.map((at, index) => ({ at, list: "line", index, name: "PQ"[index] })) : []),
  ];
  const view = () => held?.view ?? model.get("view").map(Number); // which stays while a point is dragged
  const inside = (steps, axis) => {
    const [p, q] = grid();
    const unit = Number(p) / Number(q);
    const low = BigInt(Math.ceil(view()[axis] / unit - 1e-9));
    const high = BigInt(Math.floor(view()[axis + 2] / unit + 1e-9));
    return write(times([steps < low ? low : steps > high ? high : steps, 1n], grid()));
  };
  const move = (handle, to, options) => {
    if (model.get("vertical") && handle.list === "points") to = [handle.at[0], to[1]];
    const list = state[handle.list].map((at, i) => (i === handle.index ? to : at));
    if (handle.list === "line" && list[0].join() === list[1].join()) return;
    become({ [handle.list]: list }, options);
  };
  const drag = (handle, [sx, sy], options) => {
    const [p, q] = grid();
    const unit = Number(p) / Number(q);
    move(handle, frame.back([sx, sy]).map((c, axis) => inside(BigInt(Math.round(c / unit)), axis)), options); // prettier-ignore
  };
  const step = (handle, direction, big) => {
    const [p, q] = grid();
    const to = handle.at.map((text, axis) => {
      if (!direction[axis]) return text;
      const [a, b] = read(text);
      const whole = (a * q) / (b * p) - ((a * q) % (b * p) < 0n ? 1n : 0n); // the last grid line not above it
      const on = (a * q) % (b * p) === 0n;
      const steps = direction[axis] * (big ? BIG : 1n);
      return inside(whole + steps + (steps < 0n && !on ? 1n : 0n), axis);
    });
    move(handle, to);
  };

  const where = (event) => {
    const box = svg.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const nearest = (at) => // of two in one place the one painted later, a line's
    handles()
      .reverse()
      .map((handle) => ({ handle, distance: Math.hypot(...subtract(frame.place(handle.at.map(value)), at)) }))
      .filter(({ distance }) => distance <= REACH * size())
      .sort((one, other) => one.distance - other.distance)[0]?.handle;
  svg.addEventListener("pointerdown", (event) => {
    const handle = nearest(where(event));
    if (!handle || event.button > 0) return;
    event.preventDefault();
    svg.setPointerCapture(event.pointerId);
    held = { ...handle, fresh: true, view: view(), offset: subtract(frame.place(handle.at.map(value)), where(event)) };
    focusOn(handle);
  });
  svg.addEventListener("pointermove", (event) => {
    if (!held) {
      svg.style.cursor = nearest(where(event)) ? "grab" : "";
      return;
    }
    const before = state;
    const to = where(event).map((c, axis) => c + held.offset[axis]);
    drag({ ...held, at: state[held.list][held.index] }, to, { recorded: held.fresh });
    if (state !== before) held.fresh = false;
  });
  const release = () => {
    held = null;
    paint();
  };
  for (const ending of ["pointerup", "pointercancel"]) svg.addEventListener(ending, release);
  svg.addEventListener("touchmove", (event) => held && event.preventDefault(), { passive: false });

  const focusOn = ({ list, index }) => above.querySelector(`[data-handle="${list}${index}"]`)?.focus({ preventScroll: true });
  root.addEventListener("focusin", ({ target }) => {
    selected = handles().find(({ list, index }) => target.dataset.handle === list + index) ?? selected;
  });
  root.addEventListener("keydown", (event) => {
    const handle = handles().find(({ list, index }) => event.target.dataset?.handle === list + index);
    const typed = event.ctrlKey || event.metaKey ? `Ctrl+${event.key.toLowerCase()}` : event.key;
    if (handle && ARROWS[event.key]) step(handle, ARROWS[event.key], event.shiftKey);
    else if (handle && handle.list === "points" && ["Delete", "Backspace"].includes(typed)) remove();
    else if (typed === "Ctrl+z") undo();
    else {
      if (!["Tab", "Escape"].includes(event.key)) event.stopPropagation();
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  });

  // -- buttons
  const current = () => (selected?.list === "points" && selected.index < state.points.length ? selected.index : state.points.length - 1);
  const add = () => {
    const i = current();
    const points = state.points;
    const half = fraction(1n, 2n);
    const made = i + 1 < points.length ? mixed(points[i], points[i + 1], half) : mixed(points[i - 1], points[i], fraction(3n, 2n));
    become({ points: [...points.slice(0, i + 1), made.map((text, axis) => clamped(text, axis)), ...points.slice(i + 1)], level: null }); // prettier-ignore
    focusOn({ list: "points", index: i + 1 });
  };
  const clamped = (text, axis) => {
    const bounds = [view()[axis], view()[axis + 2]];
    if (value(text) >= bounds[0] && value(text) <= bounds[1]) return text;
    const [p, q] = grid();
    return inside(BigInt(Math.round((value(text) * Number(q)) / Number(p))), axis);
  };
  const remove = () => {
    if (state.points.length <= 2 || model.get("vertical")) return;
    const i = current();
    become({ points: state.points.filter((_, k) => k !== i), level: null });
    focusOn({ list: "points", index: Math.max(i - 1, 0) });
  };
  const button = (text, title, action) => element("button", { type: "button", title, onclick: action }, text);
  const buttons = {
    undo: button("Undo", "take the last change back (Ctrl+Z)", undo),
    reset: button("Reset", "back to the start", () => become(model.get("home"))),
    add: button("Add point", "a new point behind the marked one", add),
    remove: button("Remove point", "take the marked point away (Delete)", remove),
    elevate: button("Elevate", "the same curve, one degree higher", () => become({ points: elevated(state.points), level: null })),
    projector: button("Projector", "thick lines and large letters", () => {
      model.set("projector", !model.get("projector"));
      model.save_changes();
    }),
  };
  const layers = element("details", { class: "bt-layers" }, element("summary", {}, "Show"));
  const boxes = Object.entries(model.get("layers")).map(([name, label]) => {
    const box = element("input", {
      type: "checkbox",
      onchange: () => {
        const shown = new Set(state.show);
        if (box.checked) shown.add(name);
        else shown.delete(name);
        become({ show: Object.keys(PAINTED).filter((layer) => shown.has(layer)) });
      },
    });
    layers.append(element("label", {}, box, " " + label));
    return [name, box];
  });
  const degreeTools = model.get("vertical") ? [] : [buttons.add, buttons.remove];
  if (degreeTools.length && model.get("layers").curve) degreeTools.push(buttons.elevate); // not of several curves
  tools.append(buttons.undo, buttons.reset, ...degreeTools, buttons.projector, ...(boxes.length > 1 ? [layers] : []));

  // -- sliders, each for the layers that use it
  const slider = (name, label, high, { low = 0, stride = 1, get, set, shown }) => {
    const output = element("output");
    const input = element("input", { type: "range", min: low, max: high, step: stride, "aria-label": label });
    input.addEventListener("pointerdown", () => (input.grasped = false));
    input.addEventListener("input", () => {
      pause();
      become(set(BigInt(input.value)), { recorded: !input.grasped });
      input.grasped = true;
    });
    input.addEventListener("change", () => (input.grasped = false));
    const box = element("label", { class: "bt-slider" }, element("span", {}, label), input, output);
    return { name, box, input, output, get, shown, limit: typeof high === "function" ? high : null };
  };
  const uses = (...names) => () => names.some((name) => state.show.includes(name));
  const parameter = (name, label, shown) =>
    slider(name, label, TICKS, {
      stride: 5,
      get: () => [Math.round(value(state[name]) * TICKS), state[name]],
      set: (ticks) => ({ [name]: write(fraction(ticks, BigInt(TICKS))) }),
      shown,
    });
  const counter = (name, label, high, low, shown) =>
    slider(name, label, high, { low, get: () => [state[name], String(state[name])], set: (x) => ({ [name]: Number(x) }), shown }); // prettier-ignore
  const limits = model.get("limits");
  const rows = [
    parameter("t", "t", uses("point", "levels", "halves", "tangents", "hodograph", "pieces", "frames")),
    parameter("a", "a", uses("part")),
    parameter("b", "b", uses("part")),
    counter("end", "circle at t =", 1, 0, uses("circle")),
    counter("raised", "elevations", limits.raised, 1, uses("elevated")),
    counter("depth", "halvings", limits.depth, 0, uses("halving")),
  ];
  const play = button("▶", "play: t runs from 0 to 1", () => (playing ? pause() : start()));
  const back = button("−", "one level less", () => become({ level: Math.max(shownLevel() - 1, 0) }));
  const forth = button("+", "one level more", () => become({ level: shownLevel() + 1 < state.points.length - 1 ? shownLevel() + 1 : null }));
  const level = element("output");
  const stepper = element("span", { class: "bt-slider", role: "group", "aria-label": "levels of de Casteljau's construction" }, "levels", back, level, forth); // prettier-ignore
  const shownLevel = () => (state.level === null ? state.points.length - 1 : state.level);
  sliders.append(rows[0].box, play, stepper, ...rows.slice(1).map((row) => row.box));

  const start = () => {
    remember();
    const from = state.t === "1" ? 0 : value(state.t);
    playing = { began: performance.now() - from * SECONDS * 1000 };
    const tick = (now) => {
      if (!playing) return;
      const ticks = Math.min(Math.round(((now - playing.began) / (SECONDS * 1000)) * TICKS), TICKS);
      become({ t: write(fraction(BigInt(ticks), BigInt(TICKS))) }, { recorded: false });
      if (ticks === TICKS) return pause();
      playing.next = requestAnimationFrame(tick);
    };
    playing.next = requestAnimationFrame(tick);
    paint();
  };
  const pause = () => {
    if (!playing) return;
    cancelAnimationFrame(playing.next);
    playing = null;
    become({ t: write(fraction(5n * BigInt(Math.round((value(state.t) * TICKS) / 5)), BigInt(TICKS))) }, { recorded: false }); // prettier-ignore
    paint();
  };

  // -- painting
  const paint = () => {
    const marks = [...(model.get("answer").marks ?? []), ...scene(state)];
    const two = marks.some((m) => m.frame);
    const [height, rectangles] = layout(width, view(), two, size(), model.get("vertical"));
    const frames = rectangles.map((rectangle, i) => i ? frameOf(rectangle, vectorView(marks), size()) : frameOf(rectangle, view(), size(), model.get("vertical")),
    );
    frame = frames[0];
    root.classList.toggle("bt-projector", model.get("projector"));
    if (svg.getAttribute("viewBox") !== `0 0 ${width} ${height}`) { // what is set anew is laid out anew, with the page
      svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
      svg.setAttribute("width", width);
      svg.setAttribute("height", height);
    }
    put(under, frames.map(({ rectangle: [x, y, width, height] }, i) => {
      const own = marks.filter((m) => m.frame === i).flatMap((m) => drawn(m, frames[i], styles, size()));
      return ["svg", { x, y, width, height, viewBox: `${x} ${y} ${width} ${height}` }, own];
    })); // prettier-ignore
    paintHandles();
    paintControls();
    paintReadout();
  };

  const paintHandles = () => {
    const wanted = handles();
    const places = wanted.map(({ at }) => frame.place(at.map(value)));
    const [points, ends] = [places.slice(0, state.points.length), places.slice(state.points.length)];
    const names = beside(points, size());
    if (ends.length) names.push(...acrossLine(ends, [...points, ...names], size()));
    const focused = above.querySelector(":focus")?.dataset.handle;
    put(above, wanted.map(({ at, list, index, name }, i) => {
      const [x, y] = places[i];
      const circle = (kind, r) => ["circle", { class: kind, cx: rounded(x), cy: rounded(y), r: r * size() }];
      const attributes = {
        "data-handle": list + index,
        class: "bt-handle",
        tabindex: 0,
        role: "slider",
        "aria-label": `${list === "points" ? "control point" : "point of the line"} ${name}`,
        "aria-valuenow": value(at[1]),
        "aria-valuetext": `(${at.join(", ")})`,
      };
      return ["g", attributes, [word(names[i], name, size()), circle("bt-ring", 12), circle("bt-dot", 7)]];
    })); // prettier-ignore
    const stays = focused && above.querySelector(`[data-handle="${focused}"]`);
    if (stays && !stays.matches(":focus")) stays.focus({ preventScroll: true });
  };
  let controlled = "";
  const paintControls = () => {
    const { points, line, ...settings } = state;
    const key = JSON.stringify([settings, points.length, history.length > 0, !!playing, model.get("projector")]);
    if (key === controlled) return;
    controlled = key;
    for (const { box, input, output, get, shown } of rows) {
      box.hidden = !shown();
      if (box.hidden) continue;
      const [ticks, text] = get();
      input.step = input === rows[0].input && playing ? 1 : input.step;
      input.value = ticks;
      input.setAttribute("aria-valuetext", text);
      output.textContent = text;
    }
    play.hidden = rows[0].box.hidden;
    play.textContent = playing ? "⏸" : "▶";
    play.setAttribute("aria-label", playing ? "pause" : "play");
    stepper.hidden = !state.show.includes("levels");
    level.textContent = `${shownLevel()} of ${state.points.length - 1}`;
    back.disabled = shownLevel() === 0;
    forth.disabled = state.level === null;
    buttons.undo.disabled = !history.length;
    buttons.add.disabled = buttons.elevate.disabled = state.points.length >= most;
    buttons.remove.disabled = state.points.length <= 2;
    buttons.projector.setAttribute("aria-pressed", model.get("projector"));
    for (const [name, box] of boxes) box.checked = state.show.includes(name);
  };

  let telling = null;
  const paintReadout = () => {
    const answer = model.get("answer");
    const fresh = JSON.stringify(answer.state) === JSON.stringify(state);
    readout.classList.toggle("bt-stale", !fresh);
    if (fresh && readout.innerHTML !== answer.html) readout.innerHTML = answer.html;
    clearTimeout(telling);
    if (fresh && said.textContent !== answer.text) {
      if (svg.getAttribute("aria-label")) telling = setTimeout(() => (said.textContent = answer.text), 700);
      svg.setAttribute("aria-label", answer.text);
    }
  };

  const answered = () => {
    const marks = JSON.stringify(model.get("answer").marks);
    if (marks === own) return paintReadout();
    own = marks;
    paint();
  };
  const changed = () => {
    const given = model.get("state");
    if (held || playing || JSON.stringify(given) === JSON.stringify(state)) return;
    remember();
    state = given;
    paint();
  };
  model.on("change:state", changed);
  model.on("change:answer", answered);
  model.on("change:projector", paint);
  model.on("change:view", paint);
  const resized = () => {
    const room = Math.max(Math.floor(picture.clientWidth), NARROWEST);
    if (room === width) return;
    width = room;
    paint();
  };
  const watcher = new ResizeObserver(resized);
  watcher.observe(picture);
  paint();
  return () => {
    watcher.disconnect();
    pause();
    model.off("change:state", changed);
    model.off("change:answer", answered);
    model.off("change:projector", paint);
    model.off("change:view", paint);
  };
}

// ---- A page of its own, without Python: the numbers beside the picture are exact all the same ----

const shown = (point) => `(${point.join(", ")})`;
const table = (title, rows) =>
  `<b>${escaped(title)}</b><table>${rows.map((row) => `<tr>${row.map((cell) => `<td>${escaped(cell)}</td>`).join("")}</tr>`).join("")}</table>`;

function answerTo(state) {
  const levels = exactLevels(state.points, state.t);
  const last = state.level === null ? levels.length - 1 : state.level;
  const triangle = state.points.map((_, row) => levels.slice(0, Math.min(row, last) + 1).map((level, k) => shown(level[row - k])));
  const points = table("Control points", [state.points.map(shown)]);
  const blocks = state.show.includes("levels")
    ? [points, table(`De Casteljau's triangle at t = ${state.t}`, triangle)]
    : [points, table(`The point at t = ${state.t}`, [[shown(levels.at(-1)[0])]])];
  const text = `Control points: ${state.points.map(shown).join(" ")}; at t = ${state.t}: ${shown(levels.at(-1)[0])}`;
  return { state, html: blocks.join(""), text, marks: [] };
}

export function standIn(values) {
  const listeners = {};
  const model = {
    get: (name) => values[name],
    set(name, to) {
      values[name] = to;
      for (const listener of listeners[`change:${name}`] ?? []) listener();
    },
    on: (event, listener) => (listeners[event] ??= []).push(listener),
    off() {},
    save_changes: () => requestAnimationFrame(() => model.set("answer", answerTo(values.state))), // the picture first
  };
  values.answer = answerTo(values.state);
  return model;
}

export default { render };
