// A page of its own, without Python: the numbers beside the picture are exact all the same.

const shown = (point) => `(${point.join(", ")})`;
const table = (title, rows) =>
  `<b>${escaped(title)}</b><table>${rows.map((row) => `<tr>${row.map((cell) => `<td>${escaped(cell)}</td>`).join("")}</tr>`).join("")}</table>`;

const knotsTable = (state) => {
  const [first, last] = domainOf(state);
  const stacks = [...new Set(state.knots)].map((knot) => [knot, state.knots.filter((other) => other === knot).length]);
  const cells = stacks.map(([knot, times]) => (times > 1 ? `${knot} (${times} times)` : knot));
  return table(`Knots (节点), degree ${degreeOf(state)}, domain [${first}, ${last}]`, [cells]);
};

function answerTo(state) {
  const levels = state.knots ? exactDeBoor(state.points, state.knots, state.t) : exactLevels(state.points, state.t);
  const last = state.level === null ? levels.length - 1 : state.level;
  const triangle = levels[0].map((_, row) => levels.slice(0, Math.min(row, last) + 1).map((level, k) => shown(level[row - k])));
  const found = shown(levels.at(-1)[0]);
  const parts = {
    points: table("Control points", [state.points.map(shown)]),
    knots: state.knots && knotsTable(state),
    point: table(`The point at t = ${state.t}`, [[found]]),
    levels: table(`De Casteljau's triangle at t = ${state.t}`, triangle),
    deboor: table(`De Boor's triangle (德布尔算法) at t = ${state.t}`, triangle),
  };
  const told = state.knots
    ? ["points", "knots", "point", ...state.show.filter((name) => name === "deboor")]
    : ["points", state.show.includes("levels") ? "levels" : "point"];
  const text = `Control points: ${state.points.map(shown).join(" ")}; at t = ${state.t}: ${found}`;
  return { state, html: told.map((name) => parts[name]).join(""), text, marks: [] };
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
