// replay.js: the page around the scenes: time, numbers, chart and controls.
const scenes = runs.map((run, i) => {
  const figure = el('figure', ''), canvas = el('canvas', '', {id: i ? 'scene-2' : 'scene', tabIndex: 0});
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', 'The hand and the object, ' + run.title);
  if (runs.length > 1) figure.append(el('figcaption', 'AB'[i] + ': ' + run.title));
  figure.append(canvas);
  get('scenes').append(figure);
  const facts = el('dl', '');
  for (const [name, value] of run.facts) facts.append(el('dt', name), el('dd', value));
  if (runs.length > 1) get('facts').append(el('b', 'AB'[i] + ': ' + run.title));
  get('facts').append(facts);
  return new Scene(canvas, run);
});
if (!scenes.every(scene => scene.gl)) {
  get('no-webgl').hidden = false;
  get('scenes').hidden = true;
}
const number = (parent, name, id, kind = '') => {
  const line = el('span', '', {className: kind});
  line.append(el('b', name + ' '), el('span', '', {id}));
  parent.append(line);
};
number(get('numbers'), 'step', 'step');
number(get('numbers'), 'time', 'time');
runs.forEach((run, i) => {
  const end = i ? '-2' : '', which = runs.length > 1 ? ' ' + 'AB'[i] : '';
  if (runs.length > 1) get('numbers').append(el('span', '', {className: 'line'}));
  number(get('numbers'), 'rotation' + which, 'rotation' + end);
  JOINTS.forEach((joint, j) => number(get('numbers'), joint, joint + end, j < 2 ? 'index' : 'thumb'));
  number(get('numbers'), 'index presses', 'index-force' + end, 'index');
  number(get('numbers'), 'thumb presses', 'thumb-force' + end, 'thumb');
});
const degrees = angle => Math.round(angle * 180 / Math.PI) + '\u00b0';
function show_numbers() {
  get('step').textContent = now;
  get('time').textContent = (now * step_s).toFixed(2) + ' s';
  runs.forEach((run, i) => {
    const end = i ? '-2' : '', at = place(run, now), rotation = run.rotation[at];
    get('rotation' + end).textContent = rotation.toFixed(3) + ' rad (' + degrees(rotation) + ')';
    JOINTS.forEach((joint, j) => get(joint + end).textContent = run.angles[at][j].toFixed(3) + ' rad');
    for (const finger of ['index', 'thumb'])
      get(finger + '-force' + end).textContent = run.force[finger][at].toFixed(3) + ' N';
  });
}

// Rotation over time, and below it a band a finger that is filled where it touches: drawn once a size of the page, and
// shown with the step's mark over it.
const LEFT = 64, RIGHT = 22, BAND = 12, drawn = el('canvas', '');
const chart_x = (width, step) => LEFT + (width - LEFT - RIGHT) * step / steps;
function draw_chart() {
  const canvas = get('chart'), scale = devicePixelRatio || 1, w = canvas.clientWidth, h = canvas.clientHeight;
  for (const each of [canvas, drawn]) Object.assign(each, {width: w * scale, height: h * scale});
  const c = drawn.getContext('2d'), bottom = h - 24 - runs.length * 2 * (BAND + 2);
  c.scale(scale, scale);
  c.font = '11px system-ui,sans-serif';
  const all = runs.flatMap(run => run.rotation), most = Math.max(.1, ...all), least = Math.min(0, ...all);
  const x = step => chart_x(w, step);
  const y = a => bottom - (bottom - 8) * (a - least) / (most - least);
  const text = (words, at, height, align) =>
    Object.assign(c, {fillStyle: '#555', textAlign: align}).fillText(words, at, height);
  const tick = [.05, .1, .2, .5, 1, 2, 5, 10].find(size => (most - least) / size <= 5) || 20;
  c.strokeStyle = '#ddd';
  for (let a = Math.ceil(least / tick) * tick; a <= most; a += tick) {
    c.strokeRect(LEFT, y(a), w - LEFT - RIGHT, 0);
    text(+a.toFixed(2) + ' rad', LEFT - 6, y(a) + 4, 'right');
  }
  for (let step = 0; step <= steps; step += 50) text((step * step_s).toFixed(1) + ' s', x(step), h - 6, 'center');
  runs.forEach((run, i) => {
    c.beginPath();
    c.setLineDash(i ? [6, 4] : []);
    run.rotation.forEach((a, k) => c[k ? 'lineTo' : 'moveTo'](x(k + 1), y(a)));
    Object.assign(c, {strokeStyle: '#000', lineWidth: 1.8}).stroke();
    const end = y(run.rotation[run.rows.length - 1]);
    if (runs.length > 1) text('AB'[i], x(run.rows.length) - 4, end < 20 ? end + 14 : end - 5, 'right');
    c.setLineDash([]);
    ['index', 'thumb'].forEach((finger, k) => {
      const top = bottom + 6 + (i * 2 + k) * (BAND + 2), most_n = Math.max(...run.force[finger], 1e-9);
      text(finger + (runs.length > 1 ? ' ' + 'AB'[i] : ''), LEFT - 6, top + 10, 'right');
      Object.assign(c, {fillStyle: '#f3f3f3'}).fillRect(LEFT, top, w - LEFT - RIGHT, BAND);
      c.fillStyle = k ? '#E69F00' : '#0072B2';
      run.force[finger].forEach((force, s) => {
        if (!(force > 0)) return;
        c.globalAlpha = .45 + .55 * force / most_n;
        const from = Math.round(x(s) * scale) / scale;
        c.fillRect(from, top, Math.round(x(s + 1) * scale) / scale - from, BAND);
      });
      c.globalAlpha = 1;
    });
  });
}
function show_chart() {
  const canvas = get('chart'), w = canvas.clientWidth, scale = devicePixelRatio || 1, c = canvas.getContext('2d');
  c.setTransform(1, 0, 0, 1, 0, 0);
  c.clearRect(0, 0, canvas.width, canvas.height);
  c.drawImage(drawn, 0, 0);
  c.scale(scale, scale);
  Object.assign(c, {fillStyle: '#D55E00'}).fillRect(chart_x(w, now) - 1, 2, 2, canvas.clientHeight - 22);
}

let now = 1, playing = false, carried_s = 0, last_ms = 0;
function show() {
  get('scrub').value = now;
  show_numbers();
  show_chart();
  for (const scene of scenes) scene.show(now);
}
function set_step(step) {
  now = Math.max(1, Math.min(steps, Math.round(step) || 1));
  show();
}
function note_step() {
  history.replaceState(null, '', '#step=' + now);
}
function frame(ms) {
  if (!playing) return;
  carried_s += Math.min(.25, (ms - last_ms) / 1000) * get('speed').value;
  last_ms = ms;
  const whole = Math.floor(carried_s / step_s);
  carried_s -= whole * step_s;
  if (whole > 0) set_step(now + whole > steps ? (now < steps ? steps : 1) : now + whole);
  requestAnimationFrame(frame);
}
function set_playing(on) {
  if (on == playing) return;
  playing = on;
  get('play').textContent = on ? 'Pause' : 'Play';
  last_ms = performance.now();
  if (on) requestAnimationFrame(frame);
}
function step_by_hand(step) {
  set_playing(false);
  set_step(step);
}
function step_of_address() {
  const found = /^#step=(\d+)$/.exec(location.hash);
  if (found) step_by_hand(+found[1]);
  return !!found;
}

get('scrub').max = steps;
get('scrub').oninput = event => step_by_hand(+event.target.value);
get('scrub').onchange = note_step;
get('play').onclick = () => {
  set_playing(!playing);
  if (!playing) note_step();
};
addEventListener('hashchange', step_of_address);
addEventListener('resize', show);
new ResizeObserver(() => {
  draw_chart();
  show_chart();
}).observe(get('chart'));
const chart_step = event => (event.offsetX - LEFT) / (get('chart').clientWidth - LEFT - RIGHT) * steps;
get('chart').onpointerdown = event => step_by_hand(chart_step(event));
get('chart').onpointermove = event => event.buttons && step_by_hand(chart_step(event));
function turn_camera(dx, dy) {
  camera.turn -= dx;
  camera.lift = Math.max(-1.5, Math.min(1.5, camera.lift + dy));
  show();
}
function zoom(factor) {
  camera.away = Math.max(.08, Math.min(1.2, camera.away * factor));
  show();
}
for (const {canvas} of scenes) {
  canvas.onpointerdown = event => canvas.setPointerCapture(event.pointerId);
  canvas.onpointermove = event => event.buttons && turn_camera(event.movementX * .01, event.movementY * .01);
  canvas.addEventListener('wheel', event => {
    event.preventDefault();
    zoom(Math.exp(event.deltaY * .001));
  }, {passive: false});
}
addEventListener('keydown', event => {
  const {key, target} = event, many = event.shiftKey ? 10 : 1;
  if (event.ctrlKey || event.metaKey || /INPUT|SELECT/.test(target.tagName)) return;
  if (key == ' ' && target.tagName == 'BUTTON') return;
  const steer = {ArrowLeft: [-.1, 0], ArrowRight: [.1, 0], ArrowUp: [0, .1], ArrowDown: [0, -.1]}[key];
  const actions = {' ': () => get('play').click(), ArrowLeft: () => step_by_hand(now - many),
    ArrowRight: () => step_by_hand(now + many), Home: () => step_by_hand(1), End: () => step_by_hand(steps),
    '+': () => zoom(.9), '-': () => zoom(1 / .9)};
  const action = event.altKey ? steer && (() => turn_camera(...steer)) : actions[key];
  if (!action) return;
  event.preventDefault();
  action();
});

// For who drives the page by a program. A point is in the palm frame, in m; the answer in the first canvas' CSS pixels.
window.twiddle = {
  step: () => now, setStep: step_by_hand, play: () => set_playing(true), pause: () => set_playing(false),
  isPlaying: () => playing, data: runs[0], runs,
  project(x, y, z) {
    const {canvas} = scenes[0], s = view_projection(canvas);
    const of = i => s[i] * x + s[i + 4] * y + s[i + 8] * z + s[i + 12];
    return [(1 + of(0) / of(3)) / 2 * canvas.clientWidth, (1 - of(1) / of(3)) / 2 * canvas.clientHeight];
  }
};
draw_chart();
show();
if (!step_of_address() && !matchMedia('(prefers-reduced-motion: reduce)').matches) set_playing(true);
