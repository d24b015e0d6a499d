"use strict";

const viewer = crypto.getRandomValues(new Uint32Array(2)).join("");
const token = new URLSearchParams(location.search).get("token") ?? "";
const element = (id) => document.getElementById(id);
const room = element("room");

const address = (path) => `${path}?viewer=${viewer}${token && `&token=${token}`}`;

/** Carries out an action; a sentence says what is wrong. */
async function act(action) {
  try {
    const answer = await fetch(address("do"), { method: "POST", body: JSON.stringify(action) });
    element("problem").textContent = answer.ok ? "" : await answer.text();
  } catch {
    element("problem").textContent = "The simulator does not answer.";
  }
}

// --- pictures ---

const pictures = () => {
  room.src = address("room");
  element("film").src = address("film");
};
pictures();

let turned = { right: 0, down: 0 };
let turning = false;

/** Sends the way of the pointer since the last time, one request at a time. */
async function turn() {
  if (turning || (turned.right === 0 && turned.down === 0)) {
    return;
  }
  turning = true;
  const way = turned;
  turned = { right: 0, down: 0 };
  await act({ do: "turn", ...way });
  turning = false;
  turn();
}

room.addEventListener("pointerdown", (event) => {
  room.setPointerCapture(event.pointerId);
  event.preventDefault();
  room.focus();
});
room.addEventListener("pointermove", (event) => {
  if (event.buttons === 1) {
    turned.right += event.movementX / room.clientWidth;
    turned.down += event.movementY / room.clientWidth;
    turn();
  }
});
room.addEventListener("wheel", (event) => {
  event.preventDefault();
  act({ do: "zoom", factor: Math.exp(event.deltaY * 0.0025) });
}, { passive: false });

// --- state ---

const events = new EventSource(address("state"));
events.onmessage = (event) => show(JSON.parse(event.data));

function show(state) {
  const select = element("drones");
  if (select.options.length !== state.drones.length) {
    select.replaceChildren(...state.drones.map(({ drone }) => new Option(`Drone ${drone}`, drone)));
  }
  const drone = state.drones[select.selectedIndex];
  element("time").textContent = `${state.time.toFixed(1)} s`;
  element("goals").textContent = state.goals;
  const values = [
    ["State", drone.phase],
    ["Height", `${Math.round(drone.height)} cm`],
    ["Heading", `${Math.round(drone.heading)}°`],
    ["Battery", `${drone.battery} %`],
  ];
  element("values").replaceChildren(...values.flatMap(([name, value]) => {
    const term = document.createElement("dt");
    term.textContent = name;
    const text = document.createElement("dd");
    text.textContent = value;
    return [term, text];
  }));
  element("last").textContent = drone.last ?? "";
}

element("drones").addEventListener("change", async (event) => {
  await act({ do: "select", drone: Number(event.target.value) });
  pictures();
});

// --- flight ---

const fly = (command) => act({ do: "fly", command });

for (const [name, command] of [["Take off", "takeoff"], ["Land", "land"], ["Emergency", "emergency"]]) {
  const button = document.createElement("button");
  button.textContent = name;
  button.addEventListener("click", () => fly(command));
  element("buttons").append(button);
}

/** The keys that move a stick: its index in `rc`, and the direction. */
const STICKS = {
  KeyD: [0, 1], KeyA: [0, -1], KeyW: [1, 1], KeyS: [1, -1],
  ArrowUp: [2, 1], ArrowDown: [2, -1], ArrowRight: [3, 1], ArrowLeft: [3, -1],
};
const VIEWS = ["start", "start", "front", "side", "top", "chase", "start"];
const FULL = 50;
const pressed = new Set();
let before = "rc 0 0 0 0";

addEventListener("keydown", (event) => {
  if (event.target.matches("select, input, button") || event.ctrlKey || event.altKey || event.metaKey) {
    return;
  }
  if (STICKS[event.code]) {
    pressed.add(event.code);
    event.preventDefault();
  } else if (event.code === "Space" && !event.repeat) {
    fly(element("values").textContent.includes("standing") ? "takeoff" : "land");
    event.preventDefault();
  } else if (/^Digit[0-6]$/.test(event.code)) {
    act({ do: "look", view: VIEWS[Number(event.code.at(-1))] });
  }
});
addEventListener("keyup", (event) => pressed.delete(event.code));
addEventListener("blur", () => pressed.clear());

/** Returns the sticks of the keys and of a gamepad, -1 to 1. */
function sticks() {
  const values = [0, 0, 0, 0];
  for (const key of pressed) {
    const [stick, direction] = STICKS[key];
    values[stick] += direction;
  }
  for (const pad of navigator.getGamepads?.() ?? []) {
    if (pad && pad.axes.length >= 4) {
      const [yaw, up, right, forward] = pad.axes.map((axis) => (Math.abs(axis) < 0.1 ? 0 : axis));
      [right, -forward, -up, yaw].forEach((value, stick) => { values[stick] += value; });
    }
  }
  return values.map((value) => Math.round(FULL * Math.max(-1, Math.min(1, value))));
}

setInterval(() => {
  const command = `rc ${sticks().join(" ")}`;
  if (command !== before) {
    before = command;
    fly(command);
  }
}, 50);
