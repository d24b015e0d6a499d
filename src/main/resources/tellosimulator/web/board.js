"use strict";

const tiles = new Map();

/** Creates the tile of a simulator. */
function tile() {
  const made = make("article", "", "panel tile");
  const parts = {
    picture: make("img", ""),
    name: make("h2", ""),
    title: make("p", "", "muted"),
    goals: make("p", ""),
    operator: make("p", "", "detail muted"),
    failed: make("p", "", "why detail"),
  };
  parts.picture.alt = "";
  made.append(...Object.values(parts));
  return { made, parts, shown: 0 };
}

const named = ({ name, team }) => (team ? `${name} (${team})` : name);

const write = (part, content) => {
  if (part.textContent !== content) {
    part.textContent = content;
  }
};

function showTile(seat) {
  const known = tiles.get(seat.seat) ?? tile();
  tiles.set(seat.seat, known);
  const { made, parts } = known;
  made.className = `panel tile ${seat.status === "running" ? "" : seat.status}`;
  made.classList.toggle("gone", seat.gone);
  if (seat.picture !== known.shown) {
    known.shown = seat.picture;
    parts.picture.src = address("picture", { seat: seat.seat, number: seat.picture });
  }
  write(parts.name, named(seat));
  write(parts.title, seat.title);
  const points = seat.of ? ` · ${text("points", seat.points, seat.of)}` : "";
  const goals = seat.goals ? text("goals", seat.reached, seat.goals) : "";
  write(parts.goals, `${goals}${points} · ${seat.clock.toFixed(1)} s`);
  const operator = seat.operator ? text("operator", seat.operator) : text("no-operator");
  write(parts.operator, seat.gone ? text("silent") : operator);
  write(parts.failed, seat.failed);
  return made;
}

function row(best, i) {
  const made = make("tr", "");
  const goals = best.goals ? `${best.reached} / ${best.goals}` : "";
  const points = best.of ? best.points : "";
  for (const cell of [i + 1, named(best), goals, points, `${best.clock.toFixed(1)} s`]) {
    made.append(make("td", cell));
  }
  return made;
}

function showState({ seats, ranking }) {
  const shown = seats.map(showTile);
  if ([...element("tiles").children].some((each, i) => each !== shown[i])
      || element("tiles").children.length !== shown.length) {
    element("tiles").replaceChildren(...shown);
  }
  fill("ranking", ranking.map(row));
  element("empty").hidden = seats.length > 0;
}

listen({ state: showState });

for (const button of document.querySelectorAll("[data-do]")) {
  button.addEventListener("click", () => {
    const order = { do: button.dataset.do };
    if (button.dataset.on) {
      order.on = button.dataset.on === "true";
    }
    if (order.do === "course") {
      order.seed = Math.floor(Math.random() * 1e6); // the same course for all
    }
    act(order);
  });
}

element("projector").addEventListener("click", (event) => {
  const on = document.body.classList.toggle("projector");
  event.target.setAttribute("aria-pressed", on);
});
