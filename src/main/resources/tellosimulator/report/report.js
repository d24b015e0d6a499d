// One moment for the whole page: slider, keys, address and everything that shows it.

const clock = {
  drone: data.drones[0],
  playing: false,

  build() {
    this.slider = document.getElementById('slider');
    this.slider.min = data.begin;
    this.slider.max = data.end;
    this.slider.addEventListener('input', () => this.set(Number(this.slider.value)));
    this.slider.addEventListener('keydown', event => this.key(event));
    document.addEventListener('keydown', event => {
      if (event.target === document.body || event.target.id === 'play') this.key(event);
    });
    document.getElementById('earlier').addEventListener('click', () => this.jump(-1));
    document.getElementById('later').addEventListener('click', () => this.jump(1));
    document.getElementById('play').addEventListener('click', () => this.play(!this.playing));
    addEventListener('hashchange', () => this.fromAddress());
    this.lane();
    this.choice();
  },

  /** Left and right go a tenth of a second, with shift a whole one; page keys go to entries. */
  key(event) {
    const step = event.shiftKey ? 1 : 0.1;
    const moves = {
      ArrowLeft: () => this.set(this.time - step), ArrowRight: () => this.set(this.time + step),
      PageUp: () => this.jump(-1), PageDown: () => this.jump(1),
      Home: () => this.set(data.begin), End: () => this.set(data.end),
    };
    if (!moves[event.key] || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    moves[event.key]();
  },

  /** To the next entry of the list, or the one before. */
  jump(step) {
    const times = data.entries.map(entry => entry.t);
    const next = step > 0 ? times.find(time => time > this.time + 0.005) : times.reverse().find(time => time < this.time - 0.005);
    this.set(next === undefined ? (step > 0 ? data.end : data.begin) : next);
  },

  /** A tick for each entry over the slider. */
  lane() {
    const lane = document.getElementById('lane');
    for (const entry of data.entries) {
      const tick = make('i', {class: entry.wrong ? 'wrong' : undefined});
      tick.style.left = 100 * (Math.max(data.begin, entry.t) - data.begin) / Math.max(1e-3, data.end - data.begin) + '%';
      lane.append(tick);
    }
    lane.addEventListener('click', event => {
      const {left, width} = lane.getBoundingClientRect();
      this.set(data.begin + (data.end - data.begin) * (event.clientX - left) / width);
    });
  },

  choice() {
    const box = document.getElementById('drones');
    if (data.drones.length < 2) {
      box.remove();
      return;
    }
    for (const drone of data.drones) {
      const dot = make('i', {class: 'dot'});
      dot.style.background = drone.color;
      const radio = make('input', {type: 'radio', name: 'drone', class: 'hidden', checked: drone === this.drone ? '' : undefined});
      radio.addEventListener('change', () => {
        this.drone = drone;
        charts.build();
        this.set(this.time);
      });
      box.append(make('label', {}, radio, dot, say('drone-number', drone.number)));
    }
  },

  play(on) {
    this.playing = on;
    const button = document.getElementById('play');
    button.setAttribute('aria-pressed', on);
    button.firstElementChild.textContent = on ? '❚❚' : '▶';
    if (!on) return;
    if (this.time > data.end - 0.05) this.set(data.begin);
    let before = performance.now();
    const step = now => {
      if (!this.playing) return;
      this.set(this.time + (now - before) / 1000);
      before = now;
      if (this.time >= data.end) this.play(false);
      else requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  },

  fromAddress() {
    const wanted = /[#&]t=(-?[\d.]+)/.exec(location.hash);
    if (wanted && Number.isFinite(Number(wanted[1])) && Math.abs(Number(wanted[1]) - this.time) > 0.05) this.set(Number(wanted[1]));
  },

  set(time) {
    this.time = Math.max(data.begin, Math.min(data.end, time));
    this.slider.value = this.time;
    this.slider.setAttribute('aria-valuetext', seconds(this.time));
    document.getElementById('now').textContent = seconds(this.time);
    const since = this.time - data.started;
    document.getElementById('since').textContent = since >= 0 ? say('since-takeoff', seconds(since)) : say('before-takeoff', seconds(-since));
    for (const part of [plan, charts, commandList, film]) part.show(this.time);
    clearTimeout(this.later);
    this.later = setTimeout(() => this.toAddress(), 250); // browsers limit how often it changes
  },

  toAddress() {
    try {
      history.replaceState(null, '', '#t=' + this.time.toFixed(1));
    } catch (denied) {
      // an embedding page may forbid it; everything else goes on
    }
  },
};

/** Badges, remarks, goals and facts, which do not change. */
function tell() {
  const summary = document.getElementById('summary');
  for (const {text, mood} of data.badges) {
    const sign = {good: '✓', bad: '✕'}[mood];
    summary.append(make('span', {class: 'badge ' + mood}, sign ? make('span', {'aria-hidden': 'true'}, sign) : '', text));
  }
  for (const remark of data.remarks) document.getElementById('remarks').append(make('p', {class: 'remark'}, remark));
  const goals = document.getElementById('goals');
  for (const {text, reached} of data.goals) {
    const done = reached !== undefined;
    const when = done ? make('button', {type: 'button', class: 'link'}, seconds(reached)) : make('span', {class: 'muted'}, say('not-reached'));
    if (done) when.addEventListener('click', () => clock.set(reached));
    goals.append(make('li', {}, make('span', {class: done ? 'sign good' : 'sign', 'aria-hidden': 'true'}, done ? '✓' : '○'), make('span', {}, text), when));
  }
  if (data.goals.length === 0) document.querySelector('.goals').remove();
  const score = document.getElementById('score');
  if (data.score) {
    score.caption.append(data.score.total);
    for (const {t, won, points, why} of data.score.entries) {
      const when = make('button', {type: 'button', class: 'link'}, seconds(t));
      when.addEventListener('click', () => clock.set(t));
      score.tBodies[0].append(make('tr', {}, make('th', {class: won ? 'good' : 'bad', scope: 'row'}, points), make('td', {}, why), make('td', {}, when)));
    }
  } else score.remove();
  const facts = document.getElementById('facts');
  for (const [name, text] of data.facts) {
    const date = name === say('fact.begun') ? new Date(text) : undefined;
    const shown = date && !Number.isNaN(date.getTime()) ? date.toLocaleString(data.language, {dateStyle: 'medium', timeStyle: 'medium'}) : text;
    facts.append(make('dt', {}, name), make('dd', {}, shown));
  }
}

tell();
clock.build();
commandList.build();
plan.build();
charts.build();
film.build();
clock.time = data.begin;
const linked = location.hash;
clock.set(data.started);
if (linked) clock.fromAddress();
