// Where a ball is at a time: on a leg its place is a polynomial, so any moment is exact.
export const [RESTING, ROLLING, SLIDING, AIRBORNE, OFF, POCKETED] = [0, 1, 2, 3, 4, 5];

// The leg that the ball is on; legs are [time, x, y, vx, vy, ax, ay, phase].
export function legAt(legs, time) {
  let low = 0, high = legs.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (legs[middle][0] <= time) low = middle; else high = middle - 1;
  }
  return legs[low];
}

export function stateAt(legs, time) {
  const [begun, x, y, vx, vy, ax, ay, phase] = legAt(legs, time), t = Math.max(0, time - begun);
  return {
    x: x + t * (vx + 0.5 * t * ax), y: y + t * (vy + 0.5 * t * ay),
    speed: Math.hypot(vx + t * ax, vy + t * ay), gone: phase === POCKETED || phase === OFF,
  };
}

// Points along the path until a time, m: bends of a sliding ball in chords of 20 ms.
export function path(legs, until) {
  const points = [];
  legs.forEach((leg, k) => {
    const end = Math.min(until, k + 1 < legs.length ? legs[k + 1][0] : until);
    if (leg[0] > until) return;
    const bends = leg[3] * leg[6] !== leg[4] * leg[5];
    const parts = bends ? Math.max(1, Math.ceil((end - leg[0]) / 0.02)) : 1;
    for (let i = 0; i <= parts; i++) {
      const t = ((end - leg[0]) * i) / parts;
      points.push([leg[1] + t * (leg[3] + 0.5 * t * leg[5]), leg[2] + t * (leg[4] + 0.5 * t * leg[6])]);
    }
  });
  return points;
}
