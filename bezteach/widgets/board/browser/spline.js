// B-splines: the layers of spline.py from floats, and a knot inserted exactly.

const ROW = [1n, 5n]; // from a knot down to the next one of its stack
const FINE = 24;
const TOP = 1.36;
const AT_POINT = 1e-9;

const degreeOf = (state) => state.knots.length - state.points.length - 1;
const domainOf = ({ points, knots }) => (knots ? [knots.length - points.length - 1, points.length].map((i) => knots[i]) : ["0", "1"]);
const below = (x, y) => minus(x, y)[0] < 0n;
const knotNumbers = (state) => state.knots.map(value);

// The index k with t_k <= t < t_{k+1}, at the end of the domain of the last span that is not empty; t exact, as text.
function spanAt(knots, degree, t) {
  const count = knots.length - degree - 1;
  const [at, exact] = [read(t), knots.map(read)];
  let k = degree;
  for (let i = degree; i < count; i++) if (below(exact[i], exact[i + 1]) && !below(at, exact[i])) k = i;
  return k;
}

const spansOf = (knots, degree) =>
  knots.map((_, k) => k).filter((k) => k >= degree && k < knots.length - degree - 1 && knots[k] < knots[k + 1]);

// Levels of de Boor's triangle with these arguments, of the polynomial on span k; points of any dimension.
function blossomLevels(points, knots, k, args) {
  const p = knots.length - points.length - 1;
  const levels = [points.slice(k - p, k + 1)];
  args.forEach((u, r) => {
    const level = levels.at(-1);
    levels.push(
      level.slice(1).map((q, j) => {
        const i = k - p + r + 1 + j;
        return between(level[j], q, (u - knots[i]) / (knots[i + p - r] - knots[i]));
      }),
    );
  });
  return levels;
}

const splineAt = (points, knots, k, t) => blossomLevels(points, knots, k, Array(knots.length - points.length - 1).fill(t));

function bezierOn(points, knots, k) {
  const p = knots.length - points.length - 1;
  const ends = (j) => [...Array(p - j).fill(knots[k]), ...Array(j).fill(knots[k + 1])];
  return Array.from({ length: p + 1 }, (_, j) => blossomLevels(points, knots, k, ends(j)).at(-1)[0]);
}

const bezierPieces = (points, knots) =>
  spansOf(knots, knots.length - points.length - 1).map((k) => bezierOn(points, knots, k));

// (knot as text, times, index of its last) inside the domain
function innerKnots(state) {
  const [first, last] = domainOf(state).map(read);
  return [...new Set(state.knots)]
    .filter((knot) => below(first, read(knot)) && below(read(knot), last))
    .map((knot) => [knot, state.knots.filter((other) => other === knot).length, state.knots.lastIndexOf(knot)]);
}

const stackRow = (knots, i) => -(1 + knots.slice(0, i).filter((knot) => knot === knots[i]).length);
const stackPlace = (knots, i) => [knots[i], write(times([BigInt(stackRow(knots, i)), 1n], ROW))];

// The graphs of the basis functions on the spans of their supports, as points
function graphs(knots, degree) {
  const side = Array.from({ length: degree }, (_, i) => i + 1);
  const longer = [...side.map((i) => knots[0] - i).reverse(), ...knots, ...side.map((i) => knots.at(-1) + i)];
  const count = knots.length - degree - 1;
  const mean = (j) => longer.slice(j + 1, j + degree + 1).reduce((sum, knot) => sum + knot, 0) / degree;
  const means = Array.from({ length: count + 2 * degree }, (_, j) => mean(j));
  return Array.from({ length: count }, (_, i) => {
    const control = means.map((x, j) => [x, j === i + degree ? 1 : 0]);
    const spans = spansOf(longer, degree).filter((k) => k >= i + degree && k <= i + 2 * degree);
    const pieces = spans.map((k) => bezierOn(control, longer, k));
    return pieces.flatMap((piece) => Array.from({ length: FINE + 1 }, (_, step) => pointAt(piece, step / FINE)));
  });
}

const lineView = (state, [x0, x1]) => [x0, -0.2 * (degreeOf(state) + 1.5), x1, 1.2];

const words = (at, text, frame = 0) => ({ ...mark("below", [at], "polygon", frame), words: [text] });

Object.assign(PAINTED, {
  span(points, state) {
    const k = spanAt(state.knots, degreeOf(state), state.t);
    const near = points.slice(k - degreeOf(state), k + 1);
    const piece = bezierOn(points, knotNumbers(state), k);
    return [mark("area", hull(near), "hull"), mark("curve", piece, "part"), mark("dots", near, "deciding")];
  },
  spline: (points, state) =>
    bezierPieces(points, knotNumbers(state)).map((piece, k) => mark("curve", piece, k % 2 ? "right-curve" : "left-curve")),
  breaks(points, state) {
    const near = AT_POINT * Math.max(...points.flat().map(Math.abs));
    return innerKnots(state).flatMap(([knot, times, last]) => {
      const sides = times > degreeOf(state) ? [last - times, last] : [last];
      const places = sides.map((k) => splineAt(points, knotNumbers(state), k, value(knot)).at(-1)[0]);
      const taken = points.some((p) => Math.max(...subtract(p, places.at(-1)).map(Math.abs)) <= near);
      return [mark("squares", places, "break"), ...(taken ? [] : [words(places.at(-1), `t = ${knot}`)])];
    });
  },
  deboor(points, state) {
    const k = spanAt(state.knots, degreeOf(state), state.t);
    const levels = splineAt(points, knotNumbers(state), k, value(state.t)).slice(1);
    return [
      ...levels.filter((level) => level.length > 1).map((level) => mark("line", level, "level")),
      ...levels.map((level) => mark("dots", level, level.length > 1 ? "new" : "point")),
    ];
  },
  functions(points, state) {
    const [p, t, knots] = [degreeOf(state), value(state.t), knotNumbers(state)];
    const k = spanAt(state.knots, p, state.t);
    const units = points.map((_, i) => points.map((_, j) => (i === j ? 1 : 0)));
    const values = splineAt(units, knots, k, t).at(-1)[0].slice(k - p, k + 1);
    const marks = graphs(knots, p).flatMap((graph, i) => {
      const style = i >= k - p && i <= k ? parity(i) : "rest";
      const centre = knots.slice(i, i + p + 2).reduce((sum, knot) => sum + knot, 0) / (p + 2);
      return [mark("line", graph, `function-${style}`, 1), words([centre, TOP], nameOf("N", i), 1)];
    });
    return [...marks, mark("line", [[t, 0], [t, 1]], "level", 1), mark("dots", values.map((y) => [t, y]), "new", 1)]; // prettier-ignore
  },
});

function knotLine(state) {
  const [a, b] = domainOf(state).map(value);
  const knots = knotNumbers(state);
  const lowest = state.knots.map((knot, i) => i).filter((i) => state.knots[i + 1] !== state.knots[i]);
  return [
    mark("area", [[a, 0], [b, 0], [b, 1], [a, 1]], "hull", 1), // prettier-ignore
    mark("line", [[knots[0], 0], [knots.at(-1), 0]], "axis", 1), // prettier-ignore
    ...lowest.map((i) => words(stackPlace(state.knots, i).map(value), state.knots[i], 1)),
  ];
}

// ---- Exact: what the reader does to knots ----

function exactDeBoor(points, knots, t) {
  const p = knots.length - points.length - 1;
  const k = spanAt(knots, p, t);
  const levels = [points.slice(k - p, k + 1)];
  for (let r = 0; r < p; r++) levels.push(exactStep(levels.at(-1), knots, k - p + r + 1, p - r, t));
  return levels;
}

const share = (t, from, to) => {
  const [[a, b], [c, d]] = [minus(read(t), read(from)), minus(read(to), read(from))];
  return fraction(a * d, b * c);
};

// One step of de Boor's algorithm; the first new point stands between knots number `first` and `first + width`.
const exactStep = (level, knots, first, width, t) =>
  level.slice(1).map((q, j) => mixed(level[j], q, share(t, knots[first + j], knots[first + j + width])));

// The same curve with t once more among the knots (Boehm); null where the rules do not allow it.
function inserted({ points, knots }, t) {
  const p = knots.length - points.length - 1;
  const [first, last] = domainOf({ points, knots }).map(read);
  const stands = knots.filter((knot) => knot === t).length;
  if (below(read(t), first) || below(last, read(t)) || stands > p) return null;
  const k = spanAt(knots, p, t);
  const made = exactStep(points.slice(k - p, k + 1), knots, k - p + 1, p, t);
  return {
    points: [...points.slice(0, k - p + 1), ...made, ...points.slice(k)],
    knots: inOrder([...knots, t]),
  };
}

const inOrder = (knots) => [...knots].sort((one, other) => (below(read(one), read(other)) ? -1 : one === other ? 0 : 1));

// Whether knots fit so many points: none too often, and a domain that is not empty.
function allowed(knots, count) {
  const p = knots.length - count - 1;
  return knots.every((knot, i) => knots[i + p + 1] !== knot) && knots[p] !== knots[count];
}
