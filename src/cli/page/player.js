// Time: the slider, play and pause, speed, and the keys.

import {element} from './report.js';

const speeds = [.1, .25, .5, 1, 2, 5, 10];
const slider_steps = 10000;
const usual_seconds = 20;  // for the whole series

export class player {
  constructor(data, picture) {
    this.data = data;
    this.picture = picture;
    this.count = data.t.length;
    this.place = 0;  // of 1
    this.is_playing = false;
    const span = data.t[this.count - 1] - data.t[0];
    // As fast as it turns, where that can be watched.
    this.seconds = data.unit === 's' && span >= 1 && span <= 60 ? span : usual_seconds;
    this.span = span;
    const by_id = id => document.getElementById(id);
    [this.button, this.slider, this.now, this.speed, this.pace] = ['play', 'time', 'now', 'speed', 'pace'].map(by_id);
    for (const one of speeds) {
      const option = element('option', `${one}×`);
      option.value = String(one);
      option.selected = one === 1;
      this.speed.append(option);
    }
    this.button.addEventListener('click', () => this.toggle());
    this.speed.addEventListener('change', () => this.say_pace());
    this.slider.addEventListener('input', () => {
      this.stop();
      this.go(Number(this.slider.value) / slider_steps);
    });
    document.addEventListener('keydown', event => this.key(event));
    this.say_pace();
    this.go(0);
  }

  go(place) {
    this.place = Math.max(0, Math.min(place, 1));
    const x = this.place * (this.count - 1);
    this.picture.show(x);
    const i = Math.min(Math.floor(x), this.count - 2);
    const t = this.data.t[i] + (this.data.t[i + 1] - this.data.t[i]) * (x - i);
    this.now.textContent =
        Number.isFinite(t) ? `t = ${Number(t.toPrecision(5))} ${this.data.unit}` : `sample ${Math.round(x) + 1} of ${this.count}`;
    this.slider.value = String(Math.round(slider_steps * this.place));
    this.slider.setAttribute('aria-valuetext', this.now.textContent);
    document.documentElement.dataset.place = String(this.place);
  }

  say_pace() {
    const rate = this.span * Number(this.speed.value) / this.seconds;
    this.pace.textContent = Number.isFinite(rate) ? `one second shows ${Number(rate.toPrecision(3))} ${this.data.unit}` : '';
  }

  toggle() {
    if (this.is_playing) return this.stop();
    if (this.place >= 1) this.go(0);
    this.is_playing = true;
    this.button.textContent = 'Pause';
    this.last = performance.now();
    requestAnimationFrame(time => this.frame(time));
  }

  stop() {
    this.is_playing = false;
    this.button.textContent = 'Play';
  }

  frame(time) {
    if (!this.is_playing) return;
    const passed = Math.max(0, time - this.last) / 1000;
    this.last = time;
    this.go(this.place + passed * Number(this.speed.value) / this.seconds);
    if (this.place >= 1) this.stop();
    if (this.is_playing) requestAnimationFrame(next => this.frame(next));
  }

  change_speed(by) {
    this.speed.selectedIndex = Math.max(0, Math.min(this.speed.selectedIndex + by, speeds.length - 1));
    this.say_pace();
  }

  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const own = event.target.closest?.('button, select, input, summary, a');
    const step = by => {
      this.stop();
      this.go((Math.round(this.place * (this.count - 1)) + by) / (this.count - 1));
    };
    const moves = {
      ' ': () => this.toggle(),
      ArrowLeft: () => step(-1),
      ArrowRight: () => step(1),
      Home: () => step(-this.count),
      End: () => step(this.count),
    };
    const others = {
      '-': () => this.change_speed(-1),
      '+': () => this.change_speed(1),
      '=': () => this.change_speed(1),
      b: () => document.getElementById('follow').click(),
      e: () => document.getElementById('ellipsoid').click(),
    };
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const action = (own ? undefined : moves[key]) ?? others[key];
    if (!action) return;
    event.preventDefault();
    action();
  }
}
