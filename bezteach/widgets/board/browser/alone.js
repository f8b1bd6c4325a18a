// A page of its own, without Python: the numbers beside the picture are exact all the same.

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
