"use strict";

// What the simulator's page and the teacher's board share.

const token = document.body.dataset.token;
const language = document.documentElement.lang;

const viewer = crypto.getRandomValues(new Uint32Array(2)).join("");

const element = (id) => document.getElementById(id);

/** Returns an address of this server; it is relative, because proxies may add a prefix. */
const address = (path, parameters = {}) =>
  `${path}?${new URLSearchParams({ token, viewer, language, ...parameters })}`;

/** Returns a text of the page, with %s and %2$s replaced by values. */
function text(key, ...values) {
  const template = document.querySelector(`[data-text="${key}"]`).textContent;
  let next = 0;
  return template.replace(/%(?:%|(?:(\d)\$)?s)/g, (place, number) =>
    place === "%%" ? "%" : values[number ? number - 1 : next++]);
}

/** Creates an element with a text, which is never read as markup. */
function make(tag, content, className = "") {
  const made = document.createElement(tag);
  made.textContent = content;
  made.className = className;
  return made;
}

/** Sets a text, unless it is there already: screen readers read it again. */
function say(id, content) {
  if (element(id).textContent !== content) {
    element(id).textContent = content;
  }
}

/** Replaces the entries of a list, unless they are there already: a selection would be lost. */
function fill(id, entries) {
  const list = element(id);
  const before = [...list.children].map((each) => each.outerHTML).join();
  if (entries.map((each) => each.outerHTML).join() !== before) {
    list.replaceChildren(...entries);
  }
}

/** Time for which a problem is shown at least [ms]. */
const READING = 6000;

let shownSince = 0;

function complain(sentence) {
  say("problem", sentence);
  shownSince = performance.now();
}

/** Posts to the server, and returns whether it agrees; shows a sentence if it does not. */
async function post(path, body, parameters = {}) {
  try {
    const answer = await fetch(address(path, parameters), { method: "POST", body });
    if (!answer.ok) {
      complain(await answer.text());
    } else if (performance.now() - shownSince > READING) {
      say("problem", "");
    }
    return answer.ok;
  } catch {
    complain(text("gone"));
    return false;
  }
}

const act = (action) => post("do", JSON.stringify(action));

/** Time without an event after which the server counts as away [ms]; it sends one each 5 s. */
const SILENCE = 7000;

let heard = performance.now();
let away = false;

/** Listens to the server's events while the page can be seen, and asks again if it is away. */
function listen(handlers) {
  let events = null;

  const open = () => {
    events = new EventSource(address("state"));
    for (const [name, handle] of Object.entries(handlers)) {
      events.addEventListener(name, (event) => {
        heard = performance.now();
        if (away) {
          away = false;
          say("problem", "");
        }
        handle(JSON.parse(event.data));
      });
    }
  };

  setInterval(() => {
    if (document.hidden) {
      events?.close();
      events = null;
    } else if (!events || events.readyState === EventSource.CLOSED) {
      open();
    }
    if (!document.hidden && performance.now() - heard > SILENCE) {
      away = true;
      complain(text("gone"));
    }
  }, 1000);
  document.addEventListener("visibilitychange", () => { heard = performance.now(); });
  open();
}

for (const button of document.querySelectorAll("dialog .close")) {
  button.addEventListener("click", () => button.closest("dialog").close());
}

element("language").value = language;
element("language").addEventListener("change", (event) => {
  location.search = new URLSearchParams({ token, language: event.target.value });
});
