'use strict';
// The flight as the page has it: its data, what holds at a moment, and its words.

const data = JSON.parse(document.getElementById('data').textContent);
const SVG = 'http://www.w3.org/2000/svg';

/** A text in the page's language, with values in the places %s, or %1$s and %2$s. */
function say(key, ...values) {
  let next = 0;
  return data.texts[key].replace(/%(?:(\d)\$)?s/g, (place, number) => values[number ? number - 1 : next++]);
}

/** A number with decimals, as the language writes it. */
function figure(value, decimals = 0) {
  return (Math.abs(value) < 0.5 * 10 ** -decimals ? 0 : value).toLocaleString(data.language,
      {minimumFractionDigits: decimals, maximumFractionDigits: decimals, useGrouping: false});
}

function seconds(time, decimals = 1) {
  return figure(time, decimals) + ' s';
}

/** An element; texts are always texts, never markup. */
function make(tag, attributes = {}, ...children) {
  return fill(document.createElement(tag), attributes, children);
}

function draw(tag, attributes = {}, ...children) {
  return fill(document.createElementNS(SVG, tag), attributes, children);
}

function fill(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== undefined && value !== false) element.setAttribute(name, value);
  }
  element.append(...children.filter(child => child !== undefined && child !== ''));
  return element;
}

/** A text in which what stands between backticks is code. */
function quoted(text) {
  return text.split('`').map((part, i) => i % 2 === 1 ? make('code', {}, part) : part);
}

/** The last index whose value is at most the wanted one, or the first one. */
function indexAt(sorted, wanted, value = each => each) {
  let low = 0;
  let high = sorted.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (value(sorted[middle]) <= wanted) low = middle;
    else high = middle - 1;
  }
  return low;
}

// Columns are handed over as texts, which are short and quickly read.
for (const drone of data.drones) {
  for (const [name, column] of Object.entries(drone.columns)) {
    drone.columns[name] = column === '' ? [] : column.split(' ').map(Number);
  }
}

/** What holds for a drone at a moment; nothing if its samples are missing. */
function stateAt(drone, time) {
  const {t} = drone.columns;
  if (t.length === 0) return undefined;
  const i = indexAt(t, time);
  const j = Math.min(i + 1, t.length - 1);
  const part = t[j] > t[i] ? Math.max(0, Math.min(1, (time - t[i]) / (t[j] - t[i]))) : 0;
  const state = {index: i};
  for (const name of ['x', 'y', 'z', 'speed', 'battery', 'roll', 'pitch']) {
    const column = drone.columns[name];
    state[name] = column[i] + part * (column[j] - column[i]);
  }
  state.heading = drone.columns.heading[i];
  const phases = drone.phases;
  state.phase = phases.length ? phases[indexAt(phases, time, each => each[0])][1] : '';
  const busy = drone.busy;
  state.command = busy.length ? busy[indexAt(busy, time, each => each[0])][1] : '';
  return state;
}
