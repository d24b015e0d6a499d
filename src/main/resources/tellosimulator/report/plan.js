// The room from above, in centimetres: x of the room points up, y to the left.

const plan = {
  markers: [],

  build() {
    const {width, depth, grid, measured} = data.room;
    const size = Math.max(width, depth);
    const box = document.getElementById('plan');
    this.unit = size / 100 * Math.max(1, 540 / Math.max(200, box.clientWidth)); // smaller on a phone, but not illegible
    const margin = 5 * this.unit;
    const svg = draw('svg', {role: 'img', 'aria-label': this.words(),
      viewBox: [-width / 2 - margin, -depth / 2 - margin, width + 2 * margin, depth + 2 * margin].join(' ')});
    svg.append(draw('rect', {class: 'floor', x: -width / 2, y: -depth / 2, width, height: depth, 'stroke-width': measured ? this.unit : 0}));
    svg.append(this.grid(width, depth, grid));
    if (measured) svg.append(draw('text', {class: 'side', x: 0, y: -depth / 2 - 1.5 * this.unit, 'font-size': 2.6 * this.unit}, say('front')));
    this.goals = data.goalPlaces.map(goal => this.goal(goal));
    svg.append(...this.goals.map(goal => goal.area));
    for (const thing of data.things) svg.append(this.thing(thing));
    for (const drone of data.drones) svg.append(this.start(drone));
    this.tracks = data.drones.map(drone => this.track(svg, drone));
    svg.append(...this.goals.map(goal => goal.sign));
    this.marks = data.marks.map(mark => this.mark(svg, mark));
    this.markers = data.drones.map(drone => {
      const marker = draw('g', {}, draw('path', {d: 'M0,-3.2 L2.2,2.4 L0,1.2 L-2.2,2.4 Z', fill: drone.color,
        stroke: 'var(--ink)', 'stroke-width': 0.45, 'stroke-linejoin': 'round'}));
      svg.append(marker);
      return marker;
    });
    svg.addEventListener('click', event => this.seek(event));
    this.svg = svg;
    box.append(svg);
  },

  words() {
    const things = data.things.map(thing => thing.name).filter(name => name).join(', ');
    if (!data.room.measured) return say('plan-words-flown', data.marks.length);
    return say('plan-words', figure(data.room.width), figure(data.room.depth), things || say('nothing'), data.marks.length);
  },

  grid(width, depth, step) {
    let d = '';
    if (step > 0 && width / step < 60 && depth / step < 60) {
      for (let y = step; y < width / 2; y += step) d += `M${y},${-depth / 2}v${depth}M${-y},${-depth / 2}v${depth}`;
      for (let x = step; x < depth / 2; x += step) d += `M${-width / 2},${x}h${width}M${-width / 2},${-x}h${width}`;
    }
    return draw('path', {class: 'grid', d: d + `M0,${-depth / 2}v${depth}M${-width / 2},0h${width}`, 'stroke-width': this.unit / 6});
  },

  /** Its own x points up before it is turned. */
  at(x, y, heading) {
    return `translate(${-y} ${-x}) rotate(${heading})`;
  },

  thing(thing) {
    const u = this.unit;
    const depth = Math.max(thing.depth, 0.8 * u);
    const width = Math.max(thing.width, 0.8 * u);
    const shape = thing.round
        ? draw('circle', {r: width / 2})
        : draw('rect', {x: -width / 2, y: -depth / 2, width, height: depth, rx: 0.2 * u});
    fill(shape, {fill: thing.color, 'fill-opacity': 0.75, stroke: 'var(--ink)', 'stroke-width': u / 4, 'stroke-opacity': 0.6}, []);
    const group = draw('g', {transform: this.at(thing.x, thing.y, thing.heading)}, draw('title', {}, thing.label), shape);
    if (thing.gate) {
      const way = Math.max(14, 4 * u);
      group.append(draw('path', {d: `M0,${way}V${-way}m${-u},${u}l${u},${-u}l${u},${u}`, fill: 'none', stroke: 'var(--muted)',
        'stroke-width': u / 3, 'stroke-dasharray': `${u} ${u / 2}`}));
    }
    if (thing.pad) {
      group.append(draw('path', {d: `M0,${-depth * 0.44}l${width * 0.2},${depth * 0.26}h${-width * 0.4}Z`, fill: '#1b1f24'}),
          draw('text', {y: depth * 0.36, 'font-size': depth * 0.46, 'text-anchor': 'middle', fill: '#1b1f24'}, String(thing.pad)));
      return group;
    }
    const reach = Math.max(width, depth) / 2;
    const below = thing.x < -data.room.depth / 2 + 6 * u ? -reach - 0.8 * u : Math.min(reach, depth / 2 + 2 * u) + 3 * u;
    return draw('g', {}, group, draw('text', {class: 'name', x: -thing.y, y: -thing.x + below, 'font-size': 2.4 * u, 'stroke-width': 0.7 * u}, thing.name));
  },

  /** What lies below everything, and the number or tick that lies above; the state of the moment colours both. */
  goal(goal) {
    const u = this.unit;
    const radius = Math.max(goal.radius || 0, 1.2 * u);
    const area = draw('g', {class: 'goal', transform: this.at(goal.x, goal.y, goal.heading || 0)}, draw('title', {}, goal.label));
    const sign = draw('g', {class: 'goal-sign'}, draw('title', {}, goal.label));
    if (goal.radius) {
      area.append(draw('circle', {r: radius, 'stroke-width': u / 2}));
      if (goal.landing) area.append(draw('circle', {r: radius / 2, 'stroke-width': u / 2}));
    } else {
      const gate = draw('g', {class: 'goal', transform: this.at(goal.x, goal.y, goal.heading)},
          draw('path', {d: `M${-goal.width / 2},0h${goal.width}`, 'stroke-width': 1.1 * u, 'stroke-linecap': 'round'}));
      if (goal.way !== 'either') {
        const up = goal.way === 'along' ? -1 : 1;
        const way = Math.max(30, 6 * u);
        gate.append(draw('path', {class: 'way', d: `M0,${-up * way}V${up * way}m${-1.3 * u},${-1.3 * up * u}L0,${up * way}l${1.3 * u},${-1.3 * up * u}`,
          fill: 'none', 'stroke-width': 0.6 * u}));
      }
      sign.append(gate);
    }
    const earlier = data.goalPlaces.filter(other => other.number < goal.number && other.x === goal.x && other.y === goal.y).length;
    const text = draw('text', {y: 0.9 * u, 'font-size': 2.5 * u});
    sign.append(draw('g', {class: 'tag', transform: `translate(${-goal.y + 3.8 * u * earlier} ${-goal.x - (goal.radius ? radius : 0)})`},
        draw('rect', {x: -1.7 * u, y: -1.7 * u, width: 3.4 * u, height: 3.4 * u, rx: 0.8 * u, 'stroke-width': u / 4}), text));
    return {goal, area, sign, text};
  },

  /** How one stands with a goal at a moment: done, active or later. */
  goalState(goal, time) {
    const reached = other => other.reached !== undefined && other.reached <= time;
    if (reached(goal)) return 'done';
    return data.goalsInOrder && data.goalPlaces.some(other => other.number < goal.number && !reached(other)) ? 'later' : 'active';
  },

  showGoals(time) {
    for (const {goal, area, sign, text} of this.goals) {
      const state = this.goalState(goal, time);
      const own = state === 'done' ? undefined : data.drones.find(drone => drone.number === goal.drone);
      for (const part of [area, sign]) {
        part.style.color = own ? own.color : data.markColors[state];
        part.dataset.state = state;
      }
      text.textContent = state === 'done' ? '✓' : String(goal.number);
    }
  },

  start(drone) {
    return draw('g', {transform: this.at(drone.start.x, drone.start.y, drone.start.heading)},
        draw('title', {}, say('start-of', drone.number)),
        draw('circle', {r: 2 * this.unit, fill: 'none', stroke: drone.color, 'stroke-width': 0.5 * this.unit, 'stroke-dasharray': `${this.unit} ${this.unit / 2}`}));
  },

  track(svg, drone) {
    const {x, y} = drone.columns;
    let points = '';
    const ends = x.map((value, i) => (points += `${-y[i]},${-value} `).length);
    const style = {stroke: drone.color, 'stroke-width': 0.8 * this.unit};
    const whole = draw('polyline', {class: 'path', points, ...style});
    const flown = draw('polyline', {class: 'flown', ...style});
    svg.append(whole, flown);
    return {points, ends, flown};
  },

  mark(svg, mark) {
    const u = this.unit;
    const contact = mark.kind === 'touched' || mark.kind === 'crashed';
    const group = draw('g', {class: contact ? 'mark contact' : 'mark', color: contact ? data.markColors.contact : undefined, transform: `translate(${-mark.y} ${-mark.x})`}, draw('title', {}, seconds(mark.t) + ': ' + mark.text));
    if (mark.kind === 'crashed') {
      group.append(draw('path', {class: 'back', d: `M0,${-2.6 * u}L${2.6 * u},0L0,${2.6 * u}L${-2.6 * u},0Z`, 'stroke-width': u / 2}));
    } else {
      group.append(draw('circle', {class: 'back', r: 1.7 * u, 'stroke-width': u / 2}));
    }
    group.append(draw('text', {y: 0.95 * u, 'font-size': 2.7 * u}, '✕'));
    group.addEventListener('click', event => {
      event.stopPropagation();
      clock.set(mark.t);
    });
    svg.append(group);
    return group;
  },

  /** A click beside the path goes to the moment when the drone was nearest to there. */
  seek(event) {
    const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.svg.getScreenCTM().inverse());
    const {t, x, y} = clock.drone.columns;
    let best = -1;
    let nearest = Infinity;
    for (let i = 0; i < t.length; i++) {
      const distance = (-y[i] - point.x) ** 2 + (-x[i] - point.y) ** 2;
      if (distance < nearest) [best, nearest] = [i, distance];
    }
    if (best >= 0) clock.set(t[best]);
  },

  show(time) {
    data.drones.forEach((drone, i) => {
      const state = stateAt(drone, time);
      this.markers[i].style.display = state ? '' : 'none';
      if (!state) return;
      this.markers[i].setAttribute('transform', this.at(state.x, state.y, state.heading) + ` scale(${this.unit * 0.95})`);
      const {points, ends, flown} = this.tracks[i];
      flown.setAttribute('points', points.slice(0, ends[state.index]) + `${-state.y},${-state.x}`);
    });
    data.marks.forEach((mark, i) => this.marks[i].classList.toggle('chosen', Math.abs(mark.t - time) < 0.051));
    this.showGoals(time);
    const state = stateAt(clock.drone, time);
    document.getElementById('place').textContent = state
        ? say('place', figure(state.x), figure(state.y), figure(state.z)) + ' · ' + state.phase + (state.command ? ' · ' + state.command : '')
        : '';
  },
};
