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
