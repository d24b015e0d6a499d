"use strict";

// --- pictures: the server draws, and the page shows them as they come ---

const room = element("room");
const film = element("film");

let streams = new AbortController();
let selected = 1;
let shownWidth = 0;

/** Shows a picture, and frees the one before. */
function showPicture(image, jpeg) {
  const before = image.src;
  image.src = URL.createObjectURL(new Blob([jpeg], { type: "image/jpeg" }));
  URL.revokeObjectURL(before);
}

/** Shows the pictures of a stream; the head of each says whether it is one of room or film. */
async function readPictures(body) {
  const reader = body.getReader();
  const ascii = new TextDecoder("ascii");
  let bytes = new Uint8Array();
  for (let got = await reader.read(); !got.done; got = await reader.read()) {
    const joined = new Uint8Array(bytes.length + got.value.length);
    joined.set(bytes);
    joined.set(got.value, bytes.length);
    bytes = joined;
    for (;;) {
      const start = ascii.decode(bytes.subarray(0, 200));
      const head = /^[^]*?Content-Location: (\w+)\r\nContent-Length: (\d+)\r\n\r\n/.exec(start);
      const end = head && head[0].length + Number(head[2]);
      if (!head || bytes.length < end) {
        break;
      }
      showPicture(head[1] === "film" ? film : room, bytes.slice(head[0].length, end));
      bytes = bytes.subarray(end);
    }
  }
}

/** Shows pictures until they are no longer wanted; a stream lasts a minute. */
async function showStream(parameters, { signal }) {
  while (!signal.aborted) {
    try {
      // with this header, Jupyter's proxy passes pictures on as they come
      const headers = { Accept: "text/event-stream" };
      const answer = await fetch(address("room", parameters), { headers, signal });
      if (answer.ok) {
        await readPictures(answer.body);
        continue;
      }
      complain(await answer.text());
    } catch {
      // the server is away, or the stream is no longer wanted
    }
    await new Promise((later) => setTimeout(later, 1000));
  }
}

/** Asks for the pictures in the size in which they are shown; not while the page is hidden. */
function showPictures() {
  streams.abort();
  streams = new AbortController();
  if (!document.hidden) {
    shownWidth = room.clientWidth;
    const width = Math.round(shownWidth * devicePixelRatio);
    const height = Math.round((width * 9) / 16);
    showStream({ width, height, drone: selected, film: true }, streams);
  }
}

showPictures();
document.addEventListener("visibilitychange", showPictures);

let resized = 0;
new ResizeObserver(() => {
  clearTimeout(resized);
  if (room.clientWidth !== shownWidth) {
    resized = setTimeout(showPictures, 300);
  }
}).observe(room);

// --- the viewer's camera ---

let way = { right: 0, down: 0, factor: 1 };
let moving = false;

/** Sends how far the pointer and the wheel have moved, one request at a time. */
async function move() {
  if (moving) {
    return;
  }
  moving = true;
  while (way.right !== 0 || way.down !== 0 || way.factor !== 1) {
    const { right, down, factor } = way;
    way = { right: 0, down: 0, factor: 1 };
    await act(factor === 1 ? { do: "turn", right, down } : { do: "zoom", factor });
  }
  moving = false;
}

function zoom(factor) {
  way.factor *= factor;
  move();
}

const touches = new Map();

room.addEventListener("pointerdown", (event) => {
  touches.set(event.pointerId, event);
  room.setPointerCapture(event.pointerId);
  room.focus();
  event.preventDefault();
});

room.addEventListener("pointermove", (event) => {
  const before = touches.get(event.pointerId);
  if (!before) {
    return;
  }
  const distance = () => {
    const [a, b] = touches.values();
    return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
  };
  if (touches.size === 2) {
    const apart = distance();
    touches.set(event.pointerId, event);
    zoom(apart / Math.max(1, distance()));
  } else {
    way.right += (event.clientX - before.clientX) / room.clientWidth;
    way.down += (event.clientY - before.clientY) / room.clientWidth;
    touches.set(event.pointerId, event);
    move();
  }
});

for (const end of ["pointerup", "pointercancel"]) {
  room.addEventListener(end, (event) => touches.delete(event.pointerId));
}

room.addEventListener("wheel", (event) => {
  zoom(Math.exp(event.deltaY * 0.0025));
  event.preventDefault();
}, { passive: false });

const look = (view) => act({ do: "look", view });

element("views").addEventListener("click", (event) => {
  if (event.target.dataset.view) {
    look(event.target.dataset.view);
  }
});

function press(button, pressed) {
  button.setAttribute("aria-pressed", pressed);
}

const isPressed = (button) => button.getAttribute("aria-pressed") === "true";

element("film-frame").addEventListener("click", (event) =>
  press(event.currentTarget, !isPressed(event.currentTarget)));

// --- state ---

let state = null;

const drone = () => state.drones[Math.min(selected, state.drones.length) - 1];

function showState(now) {
  const other = state && state.number !== now.number;
  state = now;
  if (other) {
    selected = 1;
    showPictures();
  }
  document.title = `${state.title} – Tello Simulator`;
  say("title", state.title);
  say("time", `${state.time.toFixed(1)} s`);
  say("pause", text(state.paused ? "resume" : "pause"));
  press(element("pause"), state.paused);
  offerFactor(state.factor);
  link("report", state.report, { language });
  link("recording", state.report, {}, "recording.zip");
  showGoals(state.goals);
  showDrone(drone());
  showCommand(state.last);
  show("wind-speed", state.wind);
  show("wind-towards", state.towards);
  show("link", state.link);
}

/** Shows the value of a field that nobody is changing. */
function show(id, value) {
  if (document.activeElement !== element(id)) {
    element(id).value = value;
  }
}

function link(id, there, parameters, path = id) {
  if (there !== element(id).hasAttribute("href")) {
    element(id).toggleAttribute("href", there);
    if (there) {
      element(id).href = address(path, parameters);
    }
  }
}

const FACTORS = ["0.25", "0.5", "1.0", "2.0", "5.0", "10.0", "max"];

function offerFactor(factor) {
  const offered = FACTORS.includes(factor) ? FACTORS : [...FACTORS, factor];
  fill("factor", offered.map((each) => {
    const option = make("option", each === "max" ? text("max") : `${Number(each)} ×`);
    option.value = each;
    return option;
  }));
  show("factor", factor);
}

function showGoals(goals) {
  element("goals").hidden = goals.tasks.length === 0;
  say("teaches", state.teaches ? text("learn", state.teaches) : "");
  const banner = {
    reached: () => text("reached"),
    failed: () => text("failed", goals.why),
    running: () => "",
  };
  say("banner", banner[goals.status]());
  element("banner").className = goals.status;
  fill("tasks", goals.tasks.map((each) =>
    make("li", each.drone ? `${each.task} (${text("drone-number", each.drone)})` : each.task,
      each.state)));
  const clock = goals.clock.toFixed(1);
  say("clock", goals.limit ? text("clock-of", clock, goals.limit) : text("clock", clock));
  say("score", goals.of == null ? "" : text("points", goals.points, goals.of));
  element("course").hidden = !state.varies;
}

function showDrone(shown) {
  if (document.activeElement !== element("drones")) { // it would close
    fill("drones", state.drones.map((each) => {
      const option = make("option", text("drone", each.drone, each.word, each.battery));
      option.value = each.drone;
      return option;
    }));
    element("drones").value = shown.drone;
  }
  const off = shown.phase === "off";
  say("power", text(off ? "start" : "stop"));
  element("takeoff").disabled = off || shown.flying;
  element("land").disabled = !shown.flying;
  element("emergency").disabled = off;
  element("demo").disabled = off || (shown.flying && !state.demo);
  say("demo", text(state.demo ? "end-demo" : "demo"));
  const values = { height: shown.height, heading: shown.heading, battery: shown.battery };
  fill("values", Object.entries(values).flatMap(([name, value]) =>
    [make("dt", text(name)), make("dd", value)]));
  const contact = () => shown.operator ? text("operator", shown.operator) : text("no-operator");
  say("contact", off ? text("off") : contact());
  fill("faults", shown.faults.map((fault) => make("li", fault)));
}

function showCommand(last) {
  if (!last) {
    say("last", "");
    return;
  }
  const reply = last.reply || (last.outcome === "running" ? "…" : text("no-answer"));
  const why = last.reason ? ` – ${last.reason}` : "";
  const whose = state.drones.length > 1 ? `${text("drone-number", last.drone)}: ` : "";
  say("last", `${whose}${last.text} → ${reply}${why}`);
  element("last").className = last.outcome;
}

/** Number of lines that the log keeps. */
const LINES = 500;

function addLines(lines) {
  const log = element("log");
  const follows = log.scrollTop + log.clientHeight >= log.scrollHeight - 20;
  for (const line of lines) {
    const item = make("li", "", line.level);
    const said = line.drone == null ? line.text : `${text("drone-number", line.drone)}: ${line.text}`;
    item.append(make("time", `${line.time.toFixed(2)} s`), make("span", said));
    log.append(item);
  }
  while (log.children.length > LINES) {
    log.firstChild.remove();
  }
  if (follows) {
    log.scrollTop = log.scrollHeight;
  }
}

listen({
  begin: (lines) => {
    element("log").replaceChildren();
    addLines(lines);
  },
  log: addLines,
  state: showState,
});

// --- actions ---

const onClick = (id, action) => element(id).addEventListener("click", action);
const onChange = (id, action) =>
  element(id).addEventListener("change", (event) => action(event.target.value));

const fly = (command) => post("do", JSON.stringify({ do: "fly", command }), { drone: selected });

for (const button of document.querySelectorAll("[data-fly]")) {
  button.addEventListener("click", () => fly(button.dataset.fly));
}
onClick("power", () => act({ do: "power", drone: drone().drone, on: drone().phase === "off" }));
onClick("demo", () => post("do", JSON.stringify({ do: "demo" }), { drone: selected }));
onClick("again", () => act({ do: "reset" }));
onClick("course", () => act({ do: "course" }));
onClick("pause", () => act({ do: "pause", on: !state.paused }));
onClick("clear-faults", () => act({ do: "clear-faults" }));
onClick("open-help", () => element("help").showModal());
onChange("factor", (factor) => act({ do: "time-factor", factor }));
onChange("link", (preset) => act({ do: "link", preset }));
for (const id of ["wind-speed", "wind-towards"]) {
  onChange(id, () => act({
    do: "wind",
    speed: element("wind-speed").valueAsNumber || 0,
    towards: -element("wind-towards").valueAsNumber || 0, // clockwise there
  }));
}
onChange("drones", (number) => {
  selected = Number(number);
  element("drones").blur();
  showDrone(drone());
  showPictures();
});

element("fault-form").addEventListener("submit", async (event) => {
  event.preventDefault();
  if (await act({ do: "inject", fault: element("fault").value })) {
    element("fault").value = "";
  }
});

onClick("open-gallery", async () => {
  const scenarios = await (await fetch(address("gallery"))).json();
  element("scenarios").replaceChildren(...scenarios.map(({ name, title, teaches }) => {
    const item = make("li", "");
    const button = make("button", title);
    button.dataset.scenario = name;
    button.append(make("div", teaches ?? "", "muted"));
    button.addEventListener("click", async () => {
      if (await act({ do: "open", scenario: name })) {
        element("gallery").close();
      }
    });
    item.append(button);
    return item;
  }));
  element("gallery").showModal();
});

element("upload").addEventListener("change", async (event) => {
  const [file] = event.target.files;
  if (file) {
    await post("scenario", file, { name: file.name });
    event.target.value = "";
    element("gallery").close();
  }
});

// --- flying by keys and with a gamepad ---

/** The keys that move a stick: its index in `rc`, and the direction. */
const STICKS = {
  KeyA: [0, -1], KeyD: [0, 1], KeyS: [1, -1], KeyW: [1, 1],
  ArrowDown: [2, -1], ArrowUp: [2, 1], ArrowLeft: [3, -1], ArrowRight: [3, 1],
};
const VIEWS = {
  Digit0: "start", Digit1: "front", Digit2: "side", Digit3: "top", Digit4: "chase",
};

/** Deflection of a stick by a key, as in the window; the second one with the shift key. */
const NORMAL = 60;
const FAST = 100;

/** Times between two commands, and until a stick that is held is sent again [ms]. */
const SHORTEST = 50;
const REPETITION = 2000;

const pressed = new Set();
let faster = false;

const takeOffOrLand = () => state && fly(drone().flying ? "land" : "takeoff");

const KEYS = {
  Space: takeOffOrLand,
  KeyF: () => fly("flip f"),
  KeyX: () => fly("emergency"),
};

onClick("keyboard", () => {
  press(element("keyboard"), !isPressed(element("keyboard")));
  element("keyboard").blur(); // the space key takes off now
  pressed.clear();
});

addEventListener("keydown", (event) => {
  const typing = event.target.matches("select, input") || document.querySelector("dialog[open]");
  if (typing || event.ctrlKey || event.altKey || event.metaKey) {
    return;
  }
  const flies = isPressed(element("keyboard"));
  faster = event.shiftKey;
  if (VIEWS[event.code]) {
    look(VIEWS[event.code]);
  } else if (event.code === "Digit5") {
    element("film-frame").click();
  } else if (event.code === "Digit6") {
    act({ do: "follow" });
  } else if (event.code === "KeyK" && !event.repeat) {
    element("keyboard").click();
  } else if (flies && STICKS[event.code]) {
    pressed.add(event.code);
    event.preventDefault();
  } else if (flies && KEYS[event.code]) {
    event.preventDefault();
    if (!event.repeat) {
      KEYS[event.code]();
    }
  }
});
addEventListener("keyup", (event) => {
  pressed.delete(event.code);
  faster = event.shiftKey;
  if (event.code === "Space" && isPressed(element("keyboard"))) {
    event.preventDefault(); // would press the button that has the focus
  }
});
addEventListener("blur", () => pressed.clear());

/** What the first buttons of a gamepad do, and which of them are held. */
const BUTTONS = [takeOffOrLand, KEYS.KeyX, KEYS.KeyF];
const held = [];

/** Returns the sticks of the keys and of a gamepad, from -100 to 100. */
function sticks() {
  const values = [0, 0, 0, 0];
  for (const key of pressed) {
    const [stick, direction] = STICKS[key];
    values[stick] += direction * (faster ? FAST : NORMAL);
  }
  const pad = [...navigator.getGamepads()].find((each) => each && each.axes.length >= 4);
  if (pad) {
    const [yaw, down, right, back] = pad.axes.map((axis) => Math.abs(axis) < 0.1 ? 0 : axis * FAST);
    [right, -back, -down, yaw].forEach((value, stick) => { values[stick] += value; });
    BUTTONS.forEach((action, i) => {
      const now = pad.buttons[i]?.pressed;
      if (now && !held[i]) {
        action();
      }
      held[i] = now;
    });
  }
  return values.map((value) => Math.round(Math.max(-FAST, Math.min(FAST, value))));
}

const CENTERED = "rc 0 0 0 0";
let sent = { command: CENTERED, at: 0 };
let steering = false;

/** Sends the newest sticks, one request at a time, until the server has taken them. */
async function steer() {
  const command = `rc ${sticks().join(" ")}`;
  const due = command !== CENTERED && performance.now() - sent.at > REPETITION;
  if (state && !steering && (command !== sent.command || due)) {
    steering = true;
    const at = performance.now();
    sent = { command: await fly(command) ? command : "unknown", at };
    steering = false;
  }
}

setInterval(steer, SHORTEST);
addEventListener("pagehide", () => {
  if (sent.command !== CENTERED) {
    const body = JSON.stringify({ do: "fly", command: CENTERED });
    navigator.sendBeacon(address("do", { drone: selected }), body);
  }
});
