// scene.js: the runs in SI units, and how they are drawn in space.
'use strict';
const runs = JSON.parse(document.getElementById('data').textContent), get = id => document.getElementById(id);
const BLUE = [0, .447, .698], ORANGE = [.902, .624, 0], RED = [.80, .22, 0], GREY = [.80, .81, .84];
const JOINTS = ['fei', 'aai', 'fet', 'ot'];
const el = (tag, text, attributes) => {
  const node = Object.assign(document.createElement(tag), attributes);
  node.textContent = text;
  return node;
};

// The rows in SI units; place n - 1 is step n.
for (const run of runs) {
  const column = (at, parts) => run.rows.map(row => row[at] / parts);
  const points = at => run.rows.map(row => [0, 1, 2].map(axis => row[at + axis] / 1e5));
  run.angles = run.rows.map(row => row.slice(0, 4).map(angle => angle / 1e4));
  run.rotation = column(4, 1e4);
  run.force = {index: column(5, 1e3), thumb: column(6, 1e3)};
  run.tips = {index: points(7), thumb: points(10)};
}
const steps = Math.max(...runs.map(run => run.rows.length)), step_s = runs[0].step_s;
const place = (run, step) => Math.min(step, run.rows.length) - 1;

// --- vectors, and 4 x 4 matrices by columns ---
const minus = (a, b) => a.map((x, i) => x - b[i]), dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = a => a.map(x => x / (Math.hypot(...a) || 1));
const times = (a, b) => {
  const c = new Float32Array(16);
  for (let i = 0; i < 16; i++) for (let k = 0; k < 4; k++) c[i] += a[k * 4 + i % 4] * b[(i >> 2) * 4 + k];
  return c;
};
const pose = p => [p[0], p[4], p[8], 0, p[1], p[5], p[9], 0, p[2], p[6], p[10], 0, p[3], p[7], p[11], 1];
const turn = a => [Math.cos(a), Math.sin(a), 0, 0, -Math.sin(a), Math.cos(a), 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const move = (p, s = 1) => [s, 0, 0, 0, 0, s, 0, 0, 0, 0, s, 0, ...p, 1];

// --- shapes: vertices of place and normal, and triangles ---
// A profile of [radius, height, normal's radius, normal's height] turned about z, or about x.
function turned(profile, about_x) {
  const vertices = [], triangles = [], sides = 24;
  profile.forEach(([r, z, nr, nz], i) => {
    for (let s = 0; s <= sides; s++) {
      const a = 2 * Math.PI * s / sides, c = Math.cos(a), q = Math.sin(a);
      vertices.push(...about_x ? [z, r * c, r * q, nz, nr * c, nr * q] : [r * c, r * q, z, nr * c, nr * q, nz]);
      const at = i * (sides + 1) + s;
      if (i && s) triangles.push(at, at - 1, at - sides - 1, at - 1, at - sides - 2, at - sides - 1);
    }
  });
  return {vertices, triangles};
}
function arc(r, x, z, from, to) {
  const points = [];
  for (let i = 0; i <= 6; i++) {
    const a = from + (to - from) * i / 6;
    points.push([x + r * Math.cos(a), z + r * Math.sin(a), Math.cos(a), Math.sin(a)]);
  }
  return points;
}
const H = Math.PI / 2;
const capsule = (r, length) => turned([...arc(r, 0, 0, -H, 0), ...arc(r, 0, length, 0, H)], true);
const cylinder = (r, h, e) => turned([[0, -h / 2, 0, -1], ...arc(e, r - e, e - h / 2, -H, 0),
  ...arc(e, r - e, h / 2 - e, 0, H), [0, h / 2, 0, 1]]);
function box(size, e) {
  const vertices = [], triangles = [];
  for (let face = 0; face < 6; face++) {
    const axis = face >> 1, sign = face & 1 ? 1 : -1, lines = [-1, -1, -1, 1, 1, 1], first = vertices.length / 6;
    const inner = size.map(s => s / 2 - e);
    const line = (i, along) => lines[i] * (inner[along] + e * [1, .6, 0, 0, .6, 1][i]);
    for (let u = 0; u < 6; u++) for (let v = 0; v < 6; v++) {
      const p = [];
      p[axis] = sign * size[axis] / 2;
      p[(axis + 1) % 3] = line(u, (axis + 1) % 3);
      p[(axis + 2) % 3] = line(v, (axis + 2) % 3);
      const core = p.map((x, i) => Math.max(-inner[i], Math.min(inner[i], x))), n = unit(minus(p, core));
      vertices.push(...core.map((x, i) => x + e * n[i]), ...n);
      const at = first + u * 6 + v;
      if (u && v) triangles.push(at, at - 1, at - 6, at - 1, at - 7, at - 6);
    }
  }
  return {vertices, triangles};
}
// A thin tube through points; 24 corners of triangles a step.
function tube(points, r) {
  const vertices = [], triangles = [];
  points.forEach((p, i) => {
    const along = unit(minus(points[Math.min(i + 1, points.length - 1)], points[Math.max(i - 1, 0)]));
    const u = unit(cross(along, [.37, .21, .9])), v = cross(along, u);
    for (let k = 0; k < 4; k++) {
      const n = u.map((x, j) => Math.cos(k * H) * x + Math.sin(k * H) * v[j]);
      vertices.push(...p.map((x, j) => x + r * n[j]), ...n);
      if (!i) continue;
      const a = i * 4 + k, b = i * 4 + (k + 1) % 4;
      triangles.push(a, b, a - 4, b, b - 4, a - 4);
    }
  });
  return {vertices, triangles};
}
const ball = r => turned([...arc(r, 0, 0, -H, 0), ...arc(r, 0, 0, 0, H)]);
const cube = (side, e) => box([side, side, side], Math.max(e, 1e-5));
const shape_of = o => o.shape == 'sphere' ? ball(o.radius)
  : o.shape == 'cylinder' ? cylinder(o.radius, o.height, o.rounding) : cube(o.height, o.rounding);

// --- camera, one for all scenes ---
const camera = {turn: -1.8, lift: .52, away: .32, at: [0, 0, 0]};
camera.at = runs[0].object.at.map((x, i) => x * .7 + [0, -.01, 0][i]);
function view_projection(canvas) {
  const {turn: a, lift: b, away: d} = camera, near = .02, far = 3, f = 1 / Math.tan(.26);
  const back = [Math.cos(b) * Math.cos(a), Math.cos(b) * Math.sin(a), Math.sin(b)];
  const eye = camera.at.map((x, i) => x + d * back[i]), right = unit(cross([0, 0, 1], back)), up = cross(back, right);
  const aspect = canvas.clientWidth / canvas.clientHeight || 1;
  const axes = [0, 1, 2].flatMap(i => [right[i], up[i], back[i], 0]);
  const view = [...axes, -dot(right, eye), -dot(up, eye), -dot(back, eye), 1];
  const deep = [(far + near) / (near - far), 2 * far * near / (near - far)];
  return times([f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, deep[0], -1, 0, 0, deep[1], 0], view);
}

// --- a scene ---
const VERTEX = `attribute vec3 place,normal;uniform mat4 model,seen;varying vec3 n,p;
void main(){p=place;n=mat3(model)*normal;gl_Position=seen*model*vec4(place,1.);}`;
const FRAGMENT = `precision mediump float;varying vec3 n,p;uniform vec4 colour;uniform float striped;
void main(){vec3 c=colour.rgb;
if(striped>0.){float a=atan(p.y,p.x);c=sin(a*6.)>0.?c:mix(c,vec3(1.),.72);if(abs(a)<.11)c=vec3(.08);}
vec3 m=normalize(n);float l=.58+.3*max(0.,dot(m,vec3(.35,-.55,.76)))+.2*m.z*.5+.1*max(0.,dot(m,vec3(-.7,-.5,-.2)));
gl_FragColor=vec4(c*l*1.12,colour.a);}`;
// Smooth edges halve the frames where there is no graphics card.
function in_software() {
  const gl = el('canvas', '').getContext('webgl'), info = gl && gl.getExtension('WEBGL_debug_renderer_info');
  return !!info && /swiftshader|llvmpipe|software/i.test(gl.getParameter(info.UNMASKED_RENDERER_WEBGL));
}
class Scene {
  constructor(canvas, run) {
    this.canvas = canvas;
    this.run = run;
    const gl = this.gl = canvas.getContext('webgl', {antialias: !in_software(), preserveDrawingBuffer: true});
    if (!gl) return;
    const program = this.program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    gl.useProgram(program);
    this.at = {};
    for (const name of ['model', 'seen', 'colour', 'striped']) this.at[name] = gl.getUniformLocation(program, name);
    this.place = gl.getAttribLocation(program, 'place');
    this.normal = gl.getAttribLocation(program, 'normal');
    gl.enableVertexAttribArray(this.place);
    gl.enableVertexAttribArray(this.normal);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.clearColor(.933, .945, .957, 1);
    this.links = run.links.map(link => this.buffers(capsule(link.radius, link.length)));
    this.palm = run.palm.size[0] > 0 && this.buffers(box(run.palm.size, Math.min(...run.palm.size) * .42));
    this.object = this.buffers(shape_of(run.object));
    this.hinge = this.buffers(cylinder(.0014, run.object.height + .026, .0007));
    this.ball = this.buffers(ball(1));
    // The path so far is thicker than all of it, which stays within where the path repeats itself.
    this.traces = ['index', 'thumb'].map(finger => [.0005, .0009].map(r => this.buffers(tube(run.tips[finger], r))));
    this.finger = run.links.map((link, i) => this.moved(i));
  }
  buffers({vertices, triangles}) {
    const gl = this.gl, make = (target, data) => {
      const buffer = gl.createBuffer();
      gl.bindBuffer(target, buffer);
      gl.bufferData(target, data, gl.STATIC_DRAW);
      return buffer;
    };
    return {vertices: make(gl.ARRAY_BUFFER, new Float32Array(vertices)),
      triangles: make(gl.ELEMENT_ARRAY_BUFFER, new Uint16Array(triangles)), count: triangles.length};
  }
  // Which finger a link is of: that of a controlled joint at its root.
  moved(i) {
    const links = this.run.links;
    while (links[i].parent >= 0) i = links[i].parent;
    return links[i].joint == 1 ? 'index' : links[i].joint == 3 ? 'thumb' : '';
  }
  draw(shape, model, colour, alpha = 1, striped = 0, count = shape.count) {
    const gl = this.gl;
    gl.bindBuffer(gl.ARRAY_BUFFER, shape.vertices);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, shape.triangles);
    gl.vertexAttribPointer(this.place, 3, gl.FLOAT, false, 24, 0);
    gl.vertexAttribPointer(this.normal, 3, gl.FLOAT, false, 24, 12);
    gl.uniformMatrix4fv(this.at.model, false, model);
    gl.uniform4f(this.at.colour, ...colour, alpha);
    gl.uniform1f(this.at.striped, striped);
    gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_SHORT, 0);
  }
  show(step) {
    const gl = this.gl, run = this.run, at = place(run, step), canvas = this.canvas;
    if (!gl) return;
    const scale = Math.min(devicePixelRatio || 1, 2);
    const width = Math.round(canvas.clientWidth * scale), height = Math.round(canvas.clientHeight * scale);
    if (canvas.width != width || canvas.height != height) Object.assign(canvas, {width, height});
    gl.viewport(0, 0, width, height);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.uniformMatrix4fv(this.at.seen, false, view_projection(canvas));
    if (this.palm) this.draw(this.palm, pose(run.palm.at), GREY);
    const frames = [];
    run.links.forEach((link, i) => {
      const own = times(pose(link.at), turn(link.joint < 0 ? link.held : run.angles[at][link.joint]));
      frames.push(link.parent < 0 ? own : times(frames[link.parent], own));
      this.draw(this.links[i], frames[i], {index: BLUE, thumb: ORANGE, '': GREY}[this.finger[i]]);
    });
    const object = run.object, still = move(object.at);
    this.draw(this.hinge, still, [.45, .45, .48]);
    this.draw(this.object, times(still, turn(object.direction * run.rotation[at])), [0, .62, .45], 1, 1);
    [BLUE, ORANGE].forEach((colour, i) => {
      const [all, so_far] = this.traces[i], still = move([0, 0, 0]);
      this.draw(all, still, colour.map(x => x + (1 - x) * .62));
      this.draw(so_far, still, colour.map(x => x * .8), 1, 0, 24 * at);
    });
    gl.enable(gl.BLEND);
    gl.depthMask(false);
    for (const finger of ['index', 'thumb']) {
      const force = run.force[finger][at];
      const radius = .0075 + .004 * Math.min(2, Math.sqrt(force));
      if (force > 0) this.draw(this.ball, move(run.tips[finger][at], radius), RED, .45);
    }
    gl.depthMask(true);
    gl.disable(gl.BLEND);
  }
}
