'use strict';
// Sorts the table by the column whose heading is chosen; again, and it is the other way round.

const table = document.getElementById('hand-ins');
const language = document.documentElement.lang;

/** Numbers begin with the largest, words with the first of the alphabet. */
function sort(heading, column) {
  const number = heading.classList.contains('number');
  const before = heading.getAttribute('aria-sort');
  const up = before ? before === 'descending' : !number;
  for (const other of table.tHead.rows[0].cells) other.removeAttribute('aria-sort');
  heading.setAttribute('aria-sort', up ? 'ascending' : 'descending');
  const compare = (one, other) => number
      ? Number(one.cells[column].dataset.value) - Number(other.cells[column].dataset.value)
      : one.cells[column].textContent.localeCompare(other.cells[column].textContent, language, {numeric: true});
  table.tBodies[0].append(...[...table.tBodies[0].rows].sort((one, other) => up ? compare(one, other) : compare(other, one)));
}

[...table.tHead.rows[0].cells].forEach((heading, column) =>
  heading.firstElementChild.addEventListener('click', () => sort(heading, column)));
