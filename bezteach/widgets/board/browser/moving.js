// What the reader moves: the parts on the screen, the state, handles, buttons, sliders, painting.

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
const STILL = 4; // pixels that a pointer may move in a click
const BIG = 5n; // grid steps of an arrow key with Shift
const KINDS = { points: "control point", line: "point of the line", knots: "knot" };
const PART = "1/24"; // of [0, 1]: where the slider of a parameter stops
const TICKS = 5; // from one stop to the next, while t plays
const SECONDS = 5;
const REMEMBERED = 200;
const ARROWS = { ArrowLeft: [-1n, 0n], ArrowRight: [1n, 0n], ArrowUp: [0n, 1n], ArrowDown: [0n, -1n] };

function render({ model, el }) {
  let state = model.get("state");
  let selected = null;
  let playing = null;
  let frames = [];
  let held = null;
  let history = [];
  let width = 640;
  let own = JSON.stringify(model.get("answer").marks); // what Python wants painted under the layers
  const styles = model.get("styles");
  const size = () => (model.get("projector") ? 1.6 : 1);
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

  // -- moving: a handle is a control point, one of the line's two, or a knot
  const placed = (list, frame, places, name) => places.map((at, index) => ({ at, list, index, frame, name: name(index) }));
  const handles = () => [
    ...placed("points", 0, state.points, (index) => nameOf(model.get("letter"), index)),
    ...placed("line", 0, state.show.includes("line") ? state.line : [], (index) => "PQ"[index]),
    ...placed("knots", 1, (state.knots ?? []).map((_, index) => stackPlace(state.knots, index)), (index) => nameOf("t", index)),
  ];
  const view = () => held?.view ?? model.get("view").map(Number); // which stays while a point is dragged
  const grid = (handle) => read(handle?.list === "knots" ? model.get("limits").knots : model.get("grid"));
  const inside = (steps, axis, handle) => {
    const [p, q] = grid(handle);
    const unit = Number(p) / Number(q);
    const [first, last] = handle?.list === "knots" ? model.get("ends") : [view()[axis], view()[axis + 2]];
    const low = BigInt(Math.ceil(first / unit - 1e-9));
    const high = BigInt(Math.floor(last / unit + 1e-9));
    return write(times([steps < low ? low : steps > high ? high : steps, 1n], grid(handle)));
  };
  const move = (handle, to, options) => {
    if (handle.list === "knots") return moveKnot(handle, to[0], options);
    if (model.get("vertical") && handle.list === "points") to = [handle.at[0], to[1]];
    const list = state[handle.list].map((at, i) => (i === handle.index ? to : at));
    if (handle.list === "line" && list[0].join() === list[1].join()) return;
    become({ [handle.list]: list }, options);
  };
  // One knot of a stack goes its way, past others if it must; t stays in the domain.
  const moveKnot = ({ index }, to, options) => {
    const others = state.knots.filter((_, i) => i !== index);
    const knots = inOrder([...others, to]);
    if (to === state.knots[index] || !allowed(knots, state.points.length)) return;
    become({ knots, t: nearestIn(domainOf({ ...state, knots }), state.t) }, options);
    const now = knots.lastIndexOf(to);
    if (held) held.index = now;
    focusOn({ list: "knots", index: now });
  };
  const nearestIn = ([first, last], t) => (below(read(t), read(first)) ? first : below(read(last), read(t)) ? last : t);
  const insert = (t) => {
    const made = state.points.length < most && inserted(state, t);
    if (made) become(made);
  };
  const drag = (handle, [sx, sy], options) => {
    const [p, q] = grid(handle);
    const unit = Number(p) / Number(q);
    const at = frames[handle.frame].back([sx, sy]);
    move(handle, at.map((c, axis) => inside(BigInt(Math.round(c / unit)), axis, handle)), options); // prettier-ignore
  };
  const step = (handle, direction, big) => {
    const [p, q] = grid(handle);
    const to = handle.at.map((text, axis) => {
      if (!direction[axis]) return text;
      const [a, b] = read(text);
      const whole = (a * q) / (b * p) - ((a * q) % (b * p) < 0n ? 1n : 0n); // the last grid line not above it
      const on = (a * q) % (b * p) === 0n;
      const steps = direction[axis] * (big ? BIG : 1n);
      return inside(whole + steps + (steps < 0n && !on ? 1n : 0n), axis, handle);
    });
    move(handle, to);
  };

  const where = (event) => {
    const box = svg.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const placeOf = ({ at, frame }) => frames[frame].place(at.map(value));
  const nearest = (at) => // of two in one place the one painted later, a line's
    handles()
      .reverse()
      .map((handle) => ({ handle, distance: Math.hypot(...subtract(placeOf(handle), at)) }))
      .filter(({ distance }) => distance <= REACH * size())
      .sort((one, other) => one.distance - other.distance)[0]?.handle;
  svg.addEventListener("pointerdown", (event) => {
    const handle = nearest(where(event));
    if (!handle || event.button > 0) return;
    event.preventDefault();
    svg.setPointerCapture(event.pointerId);
    held = { ...handle, fresh: true, view: view(), from: where(event), offset: subtract(placeOf(handle), where(event)) };
    focusOn(handle);
  });
  svg.addEventListener("pointermove", (event) => {
    if (!held) {
      svg.style.cursor = nearest(where(event)) ? "grab" : "";
      return;
    }
    const before = state;
    held.moved ||= Math.hypot(...subtract(where(event), held.from)) > STILL;
    const to = where(event).map((c, axis) => c + held.offset[axis]);
    drag(handles().find(({ list, index }) => list === held.list && index === held.index), to, { recorded: held.fresh });
    if (state !== before) held.fresh = false;
  });
  const release = ({ type }) => {
    const clicked = type === "pointerup" && held?.list === "knots" && !held.moved ? held : null;
    held = null;
    if (clicked) insert(state.knots[clicked.index]);
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
    else if (handle?.list === "knots" && ["+", "Enter"].includes(typed)) insert(state.knots[handle.index]);
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
    if (state.points.length <= 2 || model.get("vertical") || state.knots) return;
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
    insert: button("Insert knot at t", "the same curve, with t once more among the knots", () => insert(state.t)),
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
  const degreeTools = state.knots ? [buttons.insert] : model.get("vertical") ? [] : [buttons.add, buttons.remove];
  if (degreeTools.length && model.get("layers").curve) degreeTools.push(buttons.elevate); // not of several curves
  tools.append(buttons.undo, buttons.reset, ...degreeTools, buttons.projector, ...(boxes.length > 1 ? [layers] : []));

  // -- sliders, each for the layers that use it
  const slider = (name, label, high, { low = 0, stride = 1, get, set, shown }) => {
    const output = element("output");
    const input = element("input", { type: "range", min: low, max: typeof high === "function" ? high() : high, step: stride, "aria-label": label });
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
  const stop = () => read(state.knots ? model.get("limits").knots : PART);
  const ticks = () => {
    const [[p, q], [c, d]] = [minus(...domainOf(state).map(read).reverse()), stop()];
    return TICKS * Number((p * d + q * c - 1n) / (q * c));
  };
  const atTick = (tick) => {
    const [first, last] = domainOf(state).map(read);
    return nearestIn([write(first), write(last)], write(plus(first, times(fraction(BigInt(tick), BigInt(TICKS)), stop()))));
  };
  const ticksOf = (t) => {
    const [first, [c, d]] = [value(domainOf(state)[0]), stop()];
    return Math.round(((value(t) - first) * TICKS * Number(d)) / Number(c));
  };
  const parameter = (name, label, shown) =>
    slider(name, label, ticks, {
      stride: TICKS,
      get: () => [ticksOf(state[name]), state[name]],
      set: (ticks) => ({ [name]: atTick(ticks) }),
      shown,
    });
  const counter = (name, label, high, low, shown) =>
    slider(name, label, high, { low, get: () => [state[name], String(state[name])], set: (x) => ({ [name]: Number(x) }), shown }); // prettier-ignore
  const limits = model.get("limits");
  const rows = [
    parameter("t", "t", uses("point", "levels", "halves", "tangents", "hodograph", "pieces", "frames", "spline")),
    parameter("a", "a", uses("part")),
    parameter("b", "b", uses("part")),
    counter("end", "circle at t =", 1, 0, uses("circle")),
    counter("raised", "elevations", limits.raised, 1, uses("elevated")),
    counter("depth", "halvings", limits.depth, 0, uses("halving")),
  ];
  const play = button("▶", "play: t runs from its start to its end", () => (playing ? pause() : start()));
  const back = button("−", "one level less", () => become({ level: Math.max(shownLevel() - 1, 0) }));
  const forth = button("+", "one level more", () => become({ level: shownLevel() + 1 < state.points.length - 1 ? shownLevel() + 1 : null }));
  const level = element("output");
  const stepper = element("span", { class: "bt-slider", role: "group", "aria-label": "levels of de Casteljau's construction" }, "levels", back, level, forth); // prettier-ignore
  const shownLevel = () => (state.level === null ? state.points.length - 1 : state.level);
  sliders.append(rows[0].box, play, stepper, ...rows.slice(1).map((row) => row.box));

  const start = () => {
    remember();
    const from = (ticksOf(state.t) % ticks()) / ticks();
    playing = { began: performance.now() - from * SECONDS * 1000 };
    const next = (now) => {
      if (!playing) return;
      const tick = Math.min(Math.round(((now - playing.began) / (SECONDS * 1000)) * ticks()), ticks());
      become({ t: atTick(tick) }, { recorded: false });
      if (tick === ticks()) return pause();
      playing.next = requestAnimationFrame(next);
    };
    playing.next = requestAnimationFrame(next);
    paint();
  };
  const pause = () => {
    if (!playing) return;
    cancelAnimationFrame(playing.next);
    playing = null;
    become({ t: atTick(TICKS * Math.round(ticksOf(state.t) / TICKS)) }, { recorded: false });
    paint();
  };

  // -- painting
  const paint = () => {
    const marks = [...(model.get("answer").marks ?? []), ...scene(state)];
    const two = marks.some((m) => m.frame);
    const [height, rectangles] = layout(width, view(), two, size(), model.get("vertical"), !!state.knots);
    const second = () => (state.knots ? [lineView(state, model.get("ends")), size(), true] : [vectorView(marks), size()]);
    frames = rectangles.map((rectangle, i) => frameOf(rectangle, ...(i ? second() : [view(), size(), model.get("vertical")])));
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
    const places = wanted.map(placeOf);
    const of = (one) => places.filter((_, i) => wanted[i].list === one);
    const [points, ends] = [of("points"), of("line")];
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
        "aria-label": `${KINDS[list]} ${name}`,
        "aria-valuenow": value(list === "knots" ? at[0] : at[1]),
        "aria-valuetext": list === "knots" ? at[0] : `(${at.join(", ")})`,
      };
      const spots = list === "knots" ? [circle("bt-ring", 9), circle("bt-dot", 5.5)] : [circle("bt-ring", 12), circle("bt-dot", 7)];
      return ["g", attributes, names[i] ? [word(names[i], name, size()), ...spots] : spots];
    })); // prettier-ignore
    const stays = focused && above.querySelector(`[data-handle="${focused}"]`);
    if (stays && !stays.matches(":focus")) stays.focus({ preventScroll: true });
  };
  let controlled = "";
  const paintControls = () => {
    const { points, line, knots, ...settings } = state;
    const key = JSON.stringify([settings, points.length, knots, history.length > 0, !!playing, model.get("projector")]);
    if (key === controlled) return;
    controlled = key;
    for (const { box, input, output, get, shown, limit } of rows) {
      box.hidden = !shown();
      if (box.hidden) continue;
      if (limit) input.max = limit();
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
    buttons.insert.disabled = !state.knots || state.points.length >= most || !inserted(state, state.t);
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
  model.on("change:ends", paint);
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
    model.off("change:ends", paint);
  };
}
