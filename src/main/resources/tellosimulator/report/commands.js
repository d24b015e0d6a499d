// The list of commands and events; a click jumps to its moment.

const commandList = {
  rows: [],

  build() {
    const list = document.getElementById('commands');
    this.list = list;
    for (const entry of data.entries) {
      const row = make('li', {class: [entry.wrong ? 'wrong' : '', entry.event ? 'event' : ''].join(' ').trim() || undefined});
      const button = make('button', {type: 'button'},
          make('span', {class: 'when'}, figure(entry.t, 1)),
          this.sign(entry),
          make('span', {class: 'what'}, ...(entry.event ? quoted(entry.text) : [make('code', {}, entry.text)]),
              entry.count > 1 ? make('span', {class: 'muted'}, ' ×' + entry.count) : ''),
          make('span', {class: 'reply'}, this.reply(entry)),
          entry.why ? make('span', {class: 'why'}, ...quoted(entry.why)) : '');
      button.addEventListener('click', () => clock.set(entry.t));
      row.append(button);
      list.append(row);
      this.rows.push({entry, row, button});
    }
    list.addEventListener('keydown', event => this.walk(event));
    document.getElementById('problems').addEventListener('change', event => {
      for (const {entry, row} of this.rows) row.hidden = event.target.checked && !entry.wrong;
    });
    if (this.rows.length === 0) list.append(make('li', {class: 'bar muted'}, say('no-commands')));
  },

  sign(entry) {
    const signs = {answered: '✓', refused: '✕', failed: '✕', crashed: '✕', ignored: '✕', lost: '✕', touched: '✕', goal: '★'};
    const sign = entry.wrong && entry.kind === 'goal' ? '✕' : signs[entry.kind] || '·';
    return make('span', {class: 'sign' + (sign === '✓' || sign === '★' ? ' good' : ''), 'aria-hidden': 'true'}, sign);
  },

  reply(entry) {
    const drone = data.drones.length > 1 && entry.drone ? say('short-drone', entry.drone) + ' ' : '';
    const word = entry.wrong && !entry.event ? say('outcome.' + entry.kind) + (entry.reply ? ': ' : '') : '';
    const lasted = entry.lasted >= 0.05 ? ' · ' + seconds(entry.lasted) : '';
    return drone + word + (entry.reply || '') + lasted;
  },

  walk(event) {
    const step = {ArrowDown: 1, ArrowUp: -1}[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    const shown = this.rows.filter(({row}) => !row.hidden);
    const index = shown.findIndex(({button}) => button === document.activeElement);
    const next = shown[Math.max(0, Math.min(shown.length - 1, index + step))];
    if (next) {
      next.button.focus();
      clock.set(next.entry.t);
    }
  },

  show(time) {
    if (this.rows.length === 0) return;
    let index = indexAt(this.rows, time + 1e-6, ({entry}) => entry.t);
    if (this.rows[index].entry.t > time + 1e-6) index = -1;
    if (index === this.index) return;
    this.index = index;
    this.rows.forEach(({row, button}, i) => {
      row.classList.toggle('past', i <= index);
      if (i === index) button.setAttribute('aria-current', 'true');
      else button.removeAttribute('aria-current');
    });
    const row = index >= 0 ? this.rows[index].row : this.rows[0].row;
    const top = row.offsetTop - this.list.offsetTop;
    if (top < this.list.scrollTop || top + row.offsetHeight > this.list.scrollTop + this.list.clientHeight) {
      this.list.scrollTop = top - this.list.clientHeight / 2;
    }
  },
};
