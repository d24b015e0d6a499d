// Pictures of the room and of the drone's camera at the moment, and the strip of all.

const film = {
  source(picture) {
    return 'data:image/jpeg;base64,' + picture;
  },

  build() {
    const {times, room} = data.film;
    if (times.length === 0) {
      document.querySelector('.film').remove();
      return;
    }
    const box = document.getElementById('film');
    this.room = make('img', {alt: say('film-room')});
    this.camera = make('img', {});
    this.caption = make('figcaption', {});
    box.append(make('figure', {}, this.room, make('figcaption', {}, say('film-room'))), make('figure', {}, this.camera, this.caption));
    this.strip = document.getElementById('strip');
    this.lay(room);
    new ResizeObserver(() => this.lay(room)).observe(this.strip);
    this.strip.addEventListener('click', event => {
      const {left, width} = this.strip.getBoundingClientRect();
      clock.set(data.begin + (data.end - data.begin) * (event.clientX - left) / width);
    });
  },

  /** As many pictures as there is room for, each from the middle of its part of the time. */
  lay(room) {
    const count = Math.max(1, Math.min(40, Math.round(this.strip.clientWidth / 74)));
    if (this.strip.childElementCount === count) return;
    this.strip.replaceChildren();
    for (let i = 0; i < count; i++) {
      const index = this.index(data.begin + (data.end - data.begin) * (i + 0.5) / count);
      this.strip.append(make('img', {src: this.source(room[index]), alt: '', draggable: 'false'}));
    }
    if (clock.time !== undefined) this.show(clock.time);
  },

  index(time) {
    return indexAt(data.film.times, time + 0.01);
  },

  show(time) {
    if (!this.room) return;
    const index = this.index(time);
    const part = (time - data.begin) / Math.max(1e-3, data.end - data.begin);
    const slot = Math.min(this.strip.childElementCount - 1, Math.floor(part * this.strip.childElementCount));
    [...this.strip.children].forEach((picture, i) => picture.classList.toggle('now', i === slot));
    const {number} = clock.drone;
    if (this.shown === index && this.of === number) return;
    [this.shown, this.of] = [index, number];
    this.room.src = this.source(data.film.room[index]);
    this.camera.src = this.source(data.film.cameras[number][index]);
    this.camera.alt = this.caption.textContent = say('film-camera', number);
    document.getElementById('film-time').textContent = seconds(data.film.times[index]);
  },
};
