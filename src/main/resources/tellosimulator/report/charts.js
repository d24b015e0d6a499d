// Height, speed, battery and attitude over time, one below the other with one cursor.

const CHARTS = [
  {key: 'height', unit: 'cm', columns: ['z'], least: [0, 100]},
  {key: 'speed', unit: 'cm/s', columns: ['speed'], least: [0, 50]},
  {key: 'battery', unit: '%', columns: ['battery'], least: [0, 100]},
  {key: 'attitude', unit: '°', columns: ['roll', 'pitch'], least: [-10, 10]},
  {key: 'heading', unit: '°', columns: ['heading'], least: [-180, 180]},
];

const charts = {
  build() {
    const box = document.getElementById('charts');
    box.replaceChildren();
    this.cursors = [];
    this.values = [];
    for (const chart of CHARTS) box.append(this.chart(chart, clock.drone));
    box.append(this.axis());
    const seek = event => {
      const {left, width} = this.cursors[0].ownerSVGElement.getBoundingClientRect();
      clock.set(data.begin + (data.end - data.begin) * (event.clientX - left) / width);
    };
    box.onpointerdown = event => {
      if (event.button === 0) seek(event);
    };
    box.onpointermove = event => {
      if (event.buttons === 1 && event.pointerType === 'mouse') seek(event);
    };
  },

  x(time) {
    return 1000 * (time - data.begin) / Math.max(1e-3, data.end - data.begin);
  },

  chart({key, unit, columns, least}, drone) {
    const all = columns.map(name => drone.columns[name]);
    const range = all.flat().reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], [Infinity, -Infinity]);
    const low = Math.min(least[0], Math.floor(range[0] / 10) * 10);
    const high = Math.max(least[1], Math.ceil(range[1] / 10) * 10);
    const y = value => 100 * (high - value) / (high - low);
    const words = columns.map((name, i) => this.words(name === columns[0] && columns.length === 1 ? key : name, unit, all[i])).join('; ');
    const svg = draw('svg', {role: 'img', 'aria-label': words, viewBox: '0 0 1000 100', preserveAspectRatio: 'none'});
    for (const level of new Set([low, Math.max(low, 0), high])) {
      svg.append(draw('line', {x1: 0, x2: 1000, y1: y(level), y2: y(level)}));
    }
    for (const mark of data.marks.filter(each => each.drone === drone.number)) {
      svg.append(draw('line', {class: 'wrong', x1: this.x(mark.t), x2: this.x(mark.t), y1: 0, y2: 100}));
    }
    all.forEach((column, i) => this.lines(drone.columns.t, column, y, key === 'heading')
        .forEach(points => svg.append(draw('polyline', {class: i ? 'second' : undefined, points}))));
    const cursor = draw('line', {class: 'cursor', y1: -8, y2: 108});
    svg.append(cursor);
    this.cursors.push(cursor);
    const label = make('div', {class: columns.length > 1 ? 'label pair' : 'label'}, make('span', {class: 'muted'}, say('chart.' + key)));
    for (const name of columns) {
      const value = make('span', {class: 'value'});
      label.append(value);
      this.values.push({value, name, unit, sign: columns.length > 1 ? say('chart.' + name) + ' ' : ''});
    }
    return make('div', {class: 'chart'}, label, svg,
        make('div', {class: 'range', 'aria-hidden': 'true'}, make('span', {}, figure(high)), make('span', {}, figure(low))));
  },

  words(name, unit, column) {
    const known = column.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], [Infinity, -Infinity]);
    return column.length === 0
        ? say('chart.' + name) + ': ' + say('no-samples')
        : say('chart-words', say('chart.' + name), figure(known[0]) + ' ' + unit, figure(known[1]) + ' ' + unit);
  },

  /** Where a heading goes on at the other end of the circle, its line breaks. */
  lines(times, column, y, round) {
    const lines = [''];
    column.forEach((value, i) => {
      if (round && i > 0 && Math.abs(value - column[i - 1]) > 180) lines.push('');
      lines[lines.length - 1] += `${this.x(times[i]).toFixed(2)},${y(value).toFixed(2)} `;
    });
    return lines;
  },

  axis() {
    const scale = make('div');
    const length = Math.max(1e-3, data.end - data.begin);
    const step = [0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200, 3600].find(each => length / each <= 9) || 3600 * Math.ceil(length / 9 / 3600);
    for (let time = Math.ceil(data.begin / step) * step; time <= data.end; time += step) {
      const tick = make('span', {}, seconds(time, step < 1 ? 1 : 0));
      tick.style.left = this.x(time) / 10 + '%';
      scale.append(tick);
    }
    return make('div', {class: 'axis', 'aria-hidden': 'true'}, scale);
  },

  show(time) {
    for (const cursor of this.cursors) {
      cursor.setAttribute('x1', this.x(time));
      cursor.setAttribute('x2', this.x(time));
    }
    const state = stateAt(clock.drone, time);
    for (const {value, name, unit, sign} of this.values) {
      const text = state ? figure(state[name], name === 'roll' || name === 'pitch' ? 1 : 0) : '–';
      value.replaceChildren(sign ? make('small', {}, sign) : '', text, make('small', {}, ' ' + unit));
    }
  },
};
