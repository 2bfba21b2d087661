// The motion between two samples, to be looked at.

import {Quaternion, Vector3} from 'three';

// Quaternions of the data are w, x, y, z.
const quaternion_of = ([w, x, y, z]) => new Quaternion(x, y, z, w);

// The greatest turn between two samples that can be told from the others, in radians.
const greatest_turn = 2;

export class motion {
  constructor(data) {
    this.count = data.t.length;
    this.attitudes = data.q?.map(quaternion_of);
    this.omegas = data.omega?.map(one => new Vector3(...one));
    this.directions = data.j?.map(one => new Vector3(...one));
    const step = this.count > 1 ? (data.t[this.count - 1] - data.t[0]) / (this.count - 1) : 0;
    this.step = Number.isFinite(step) ? step : 0;
    // q and -q are one attitude: the nearer to the one before.
    this.attitudes?.forEach((q, i) => {
      if (i > 0 && q.dot(this.attitudes[i - 1]) < 0) q.set(-q.x, -q.y, -q.z, -q.w);
    });
    this.is_sparse = this.turn_between_samples() > greatest_turn;
  }

  // By the angular velocity where that is known, else by the attitudes, of which whole turns cannot be seen.
  turn_between_samples() {
    if (this.omegas) return Math.max(...this.omegas.map(one => one.length())) * Math.abs(this.step);
    if (!this.attitudes) return 0;
    return Math.max(...this.attitudes.slice(1).map((q, i) => q.angleTo(this.attitudes[i])));
  }

  // Where x lies in [0, count - 1]: the sample before it and how far beyond. Too sparse samples are shown as they are.
  place(x) {
    const at = this.is_sparse ? Math.round(x) : x;
    const i = Math.max(0, Math.min(Math.floor(at), this.count - 2));
    return [i, at - i];
  }

  // dq/dt = q omega/2 with omega in the body's axes, times the step.
  slope(i) {
    const w = this.omegas[i];
    const rate = new Quaternion(w.x, w.y, w.z, 0);
    const change = this.attitudes[i].clone().multiply(rate);
    return [change.x, change.y, change.z, change.w].map(part => part * this.step / 2);
  }

  // Hermite's cubic through both attitudes with their slopes; without these, the shortest turn.
  attitude(x) {
    if (!this.attitudes) return new Quaternion();
    const [i, s] = this.place(x);
    const [from, to] = [this.attitudes[i], this.attitudes[i + 1]];
    if (!this.omegas || this.is_sparse) return from.clone().slerp(to, s);
    const [begin, end] = [this.slope(i), this.slope(i + 1)];
    const [a, b] = [from.toArray(), to.toArray()];
    const parts = a.map((p, k) => p * (1 + 2 * s) * (1 - s) ** 2 + begin[k] * s * (1 - s) ** 2 + b[k] * s * s * (3 - 2 * s) + end[k] * s * s * (s - 1));
    return new Quaternion(...parts).normalize();
  }

  // Catmull's and Rom's cubic through the samples.
  between(samples, x) {
    const [i, s] = this.place(x);
    const at = k => samples[Math.max(0, Math.min(k, this.count - 1))];
    const [p, a, b, q] = [at(i - 1), at(i), at(i + 1), at(i + 2)];
    const begin = b.clone().sub(p).divideScalar(2);
    const end = q.clone().sub(a).divideScalar(2);
    return a.clone().multiplyScalar((1 + 2 * s) * (1 - s) ** 2)
        .addScaledVector(begin, s * (1 - s) ** 2)
        .addScaledVector(b, s * s * (3 - 2 * s))
        .addScaledVector(end, s * s * (s - 1));
  }
  omega(x) {
    return this.between(this.omegas, x);
  }
  // J/|J| in the body.
  direction(x) {
    return this.between(this.directions, x).normalize();
  }

  // Of a function of x: some points between each two samples, at most so many in all.
  curve(f) {
    const most = 40000;
    const between = this.is_sparse ? 1 : Math.max(1, Math.min(16, Math.floor(most / this.count)));
    return Array.from({length: (this.count - 1) * between + 1}, (_, k) => f(k / between));
  }
}
