// The scene: each layer's marks from floats, in the order and the shape of scene.py.

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

function turnsLeft(p, q, r) {
  const [one, other] = [subtract(q, p), subtract(r, p)];
  return cross(one, other) > ROUNDING * Math.hypot(...one) * Math.hypot(...other);
}

function hull(points) {
  const ordered = [...new Map(points.map((p) => [p.join(), p])).values()].sort((p, q) => p[0] - q[0] || p[1] - q[1]);
  if (ordered.length < 3) return ordered;
  const chain = (list) => {
    const corners = [];
    for (const point of list) {
      while (corners.length > 1 && !turnsLeft(...corners.slice(-2), point)) corners.pop();
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
  const marks = Object.keys(PAINTED)
    .filter((name) => state.show.includes(name))
    .flatMap((name) => PAINTED[name](points, state));
  return state.knots ? [...knotLine(state), ...marks] : marks;
}

const nameOf = (letter, i) => letter + String(i).replace(/\d/g, (digit) => SUBSCRIPTS[digit]);
