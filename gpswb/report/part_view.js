// SPDX-License-Identifier: LGPL-2.1-or-later
// Views of one mesh that turn together: WebGL 2, one canvas, one scissored viewport a panel.
"use strict";

// Integers come as differences, byte planes, deflate, base64 (gpswb/report/pack.py).
async function unpack(packed) {
  const text = atob(packed.data);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  const planes = new Uint8Array(await new Response(stream).arrayBuffer());
  const n = packed.length, out = new Int32Array(n);
  for (let i = 0, sum = 0; i < n; i++) {
    sum = (sum + (planes[i] | planes[n + i] << 8 | planes[2 * n + i] << 16 | planes[3 * n + i] << 24)) | 0;
    out[i] = sum;
  }
  return out;
}

const PLACE = `#version 300 es
precision highp float;
in vec3 position; in vec3 colour; in float chosen; in vec4 name;
uniform mat3 turn; uniform vec3 size; uniform vec2 scale; uniform vec2 pan; uniform float lift;
out vec3 at; flat out vec3 tint; flat out float pick; flat out vec4 id;
void main() {
  at = turn * ((position - 0.5) * size);
  tint = colour; pick = chosen; id = name;
  gl_Position = vec4(at.xy * scale + pan, -at.z - lift, 1.0);
  gl_PointSize = 1.5;
}`;

const PAINT = `#version 300 es
precision highp float;
in vec3 at; flat in vec3 tint; flat in float pick; flat in vec4 id;
uniform int mode; uniform vec3 line; uniform float dim; uniform vec3 ground;
out vec4 pixel;
void main() {
  if (mode == 2) { pixel = id; return; }
  if (mode == 1) { pixel = vec4(line, 1.0); return; }
  vec3 normal = normalize(cross(dFdx(at), dFdy(at)));
  float light = 0.52 + 0.36 * abs(normal.z) + 0.12 * abs(dot(normal, vec3(0.5, 0.75, 0.43)));
  vec3 lit = tint * light;
  float grey = dot(lit, vec3(0.3, 0.6, 0.1));
  pixel = vec4(pick > 0.5 ? lit : mix(lit, mix(ground, vec3(grey), 0.25), dim), 1.0);
}`;

class Views {
  // mesh: {vertices (3n ints 0..65535, x then y then z), triangles (3m), region (m), edges {name: ints}}
  constructor(canvas, panels, mesh, size) {
    const gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });
    if (!gl) throw new Error("this browser offers no WebGL 2: the 3-D views are left out");
    Object.assign(this, { canvas, panels, gl, mesh, size });
    this.facets = mesh.triangles.length / 3;
    this.look("iso");
    this.selected = false;
    this.showEdges = true;
    this.onpick = () => {};
    this.program = this.link();
    this.at = (name) => gl.getUniformLocation(this.program, name);
    this.solid = gl.createVertexArray();
    gl.bindVertexArray(this.solid);
    this.attribute("position", this.places(mesh.triangles), 4, gl.UNSIGNED_SHORT);
    const names = new Uint8Array(this.facets * 12);
    mesh.region.forEach((r, f) => {
      for (let k = 0; k < 3; k++) names.set([(r + 1) & 255, (r + 1) >> 8 & 255, (r + 1) >> 16 & 255, 255], f * 12 + k * 4);
    });
    this.attribute("name", names, 4, gl.UNSIGNED_BYTE);
    this.chosen = this.attribute("chosen", new Uint8Array(this.facets * 3), 1, gl.UNSIGNED_BYTE);
    this.colours = {};
    this.lines = {};
    for (const [name, ends] of Object.entries(mesh.edges)) {
      const array = gl.createVertexArray();
      gl.bindVertexArray(array);
      this.attribute("position", this.places(ends), 4, gl.UNSIGNED_SHORT);
      this.lines[name] = { array, count: ends.length };
    }
    this.listen();
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  link() {
    const gl = this.gl, program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, PLACE], [gl.FRAGMENT_SHADER, PAINT]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    return program;
  }

  places(indices) {
    const v = this.mesh.vertices, n = v.length / 3, out = new Uint16Array(indices.length * 4);
    for (let i = 0; i < indices.length; i++) {
      const k = indices[i];
      out[4 * i] = v[k]; out[4 * i + 1] = v[n + k]; out[4 * i + 2] = v[2 * n + k];
    }
    return out;
  }

  attribute(name, data, width, type) {
    const gl = this.gl, place = gl.getAttribLocation(this.program, name), buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, width, type, name !== "chosen", 0, 0);
    return buffer;
  }

  // rgb: Uint8Array (3m), a colour a facet.
  paint(view, rgb) {
    const gl = this.gl, data = new Uint8Array(this.facets * 12);
    for (let f = 0; f < this.facets; f++)
      for (let k = 0; k < 3; k++) data.set([rgb[3 * f], rgb[3 * f + 1], rgb[3 * f + 2], 255], 12 * f + 4 * k);
    this.colours[view] ??= gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.colours[view]);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
    this.ask();
  }

  // test: facet -> boolean, or null to select nothing.
  select(test) {
    const gl = this.gl, data = new Uint8Array(this.facets * 3);
    if (test) for (let f = 0; f < this.facets; f++) if (test(f)) data.fill(1, 3 * f, 3 * f + 3);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.chosen);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
    this.selected = Boolean(test);
    this.ask();
  }

  look(from) {
    const views = { iso: [-0.62, -1.05], front: [0, -Math.PI / 2], top: [0, 0], right: [-Math.PI / 2, -Math.PI / 2] };
    [this.yaw, this.pitch] = views[from];
    const m = this.turn(), p = this.panels[0].getBoundingClientRect(), side = Math.min(p.width, p.height) || 1;
    const extent = (i) => [0, 1, 2].reduce((sum, j) => sum + Math.abs(m[3 * j + i]) * this.size[j], 1e-9);
    this.zoom = 1.75 * Math.min(p.width / extent(0), p.height / extent(1)) / side;
    this.pan = [0, 0];
    this.ask();
  }

  ask() {
    if (this.waiting || !this.program) return;
    this.waiting = true;
    requestAnimationFrame(() => { this.waiting = false; this.draw(); });
  }

  turn() {
    const [s, c, t, d] = [Math.sin(this.yaw), Math.cos(this.yaw), Math.sin(this.pitch), Math.cos(this.pitch)];
    return [c, d * s, t * s, -s, d * c, t * c, 0, -t, d]; // columns of Rx(pitch)·Rz(yaw)
  }

  begin(width, height) {
    const gl = this.gl;
    gl.useProgram(this.program);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL); // a sharp edge is drawn over the border that it coincides with
    gl.uniformMatrix3fv(this.at("turn"), false, this.turn());
    gl.uniform3fv(this.at("size"), this.size);
    const side = this.zoom * Math.min(width, height);
    gl.uniform2f(this.at("scale"), side / width, side / height);
    gl.uniform2fv(this.at("pan"), this.pan);
  }

  bindColour(view) {
    const gl = this.gl, place = gl.getAttribLocation(this.program, "colour");
    gl.bindVertexArray(this.solid);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.colours[view]);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, 4, gl.UNSIGNED_BYTE, true, 0, 0);
  }

  draw() {
    const gl = this.gl, box = this.canvas.getBoundingClientRect(), ratio = Math.min(2, devicePixelRatio || 1);
    const [w, h] = [Math.round(box.width * ratio), Math.round(box.height * ratio)];
    if (!w || !h) return;
    if (this.canvas.width !== w || this.canvas.height !== h) Object.assign(this.canvas, { width: w, height: h });
    const style = getComputedStyle(this.canvas);
    const colour = (name) => {
      const hex = parseInt(style.getPropertyValue(name).trim().slice(1).replace(/^(.)(.)(.)$/, "$1$1$2$2$3$3"), 16);
      return [hex >> 16 & 255, hex >> 8 & 255, hex & 255].map((x) => x / 255);
    };
    const ground = colour("--view"), edge = colour("--edge");
    gl.disable(gl.SCISSOR_TEST);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.enable(gl.SCISSOR_TEST);
    for (const panel of this.panels) {
      const view = panel.dataset.view, p = panel.getBoundingClientRect();
      if (!this.colours[view]) continue;
      const port = [p.left - box.left, box.bottom - p.bottom, p.width, p.height].map((x) => Math.round(x * ratio));
      gl.viewport(...port);
      gl.scissor(...port);
      gl.clearColor(...ground, 1);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      this.begin(port[2], port[3]);
      gl.uniform3fv(this.at("ground"), ground);
      gl.uniform1f(this.at("dim"), this.selected ? 0.86 : 0);
      gl.uniform1f(this.at("lift"), 0);
      gl.uniform1i(this.at("mode"), view === "points" ? 1 : 0);
      gl.uniform3fv(this.at("line"), edge);
      this.bindColour(view);
      gl.drawArrays(view === "points" ? gl.POINTS : gl.TRIANGLES, 0, this.facets * 3);
      if (!this.showEdges || view === "points") continue;
      gl.uniform1i(this.at("mode"), 1);
      gl.uniform1f(this.at("lift"), 0.0012);
      const border = ["unvoted", "shape", "initial"].includes(view) ? "initial" : "region";
      this.strokes(border, edge);
      if (["unvoted", "shape", "class"].includes(view)) this.strokes("sharp", this.sharpColour);
    }
  }

  strokes(name, colour) {
    const gl = this.gl, line = this.lines[name];
    gl.bindVertexArray(line.array);
    gl.uniform3fv(this.at("line"), colour);
    gl.drawArrays(gl.LINES, 0, line.count);
  }

  // The region under a point of the window, by drawing names into a single pixel.
  regionAt(panel, x, y) {
    const gl = this.gl, p = panel.getBoundingClientRect();
    this.target ??= gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
    if (!this.spot) {
      this.spot = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, this.spot);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, null);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.spot, 0);
      const depth = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
      gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT16, 1, 1);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
    }
    gl.disable(gl.SCISSOR_TEST);
    gl.viewport(-Math.floor(x - p.left), -Math.floor(p.bottom - y), Math.round(p.width), Math.round(p.height));
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.begin(p.width, p.height);
    gl.uniform1i(this.at("mode"), 2);
    gl.uniform1f(this.at("lift"), 0);
    gl.bindVertexArray(this.solid);
    gl.drawArrays(gl.TRIANGLES, 0, this.facets * 3);
    const pixel = new Uint8Array(4);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    this.ask();
    return pixel[0] + (pixel[1] << 8) + (pixel[2] << 16) - 1;
  }

  listen() {
    for (const panel of this.panels) {
      let from = null, moved = 0;
      panel.addEventListener("pointerdown", (e) => { panel.setPointerCapture(e.pointerId); from = [e.clientX, e.clientY]; moved = 0; });
      panel.addEventListener("pointermove", (e) => {
        if (!from) return;
        const [dx, dy] = [e.clientX - from[0], e.clientY - from[1]];
        from = [e.clientX, e.clientY];
        moved += Math.abs(dx) + Math.abs(dy);
        if (e.shiftKey || e.buttons & 6) {
          const p = panel.getBoundingClientRect();
          this.pan = [this.pan[0] + 2 * dx / p.width, this.pan[1] - 2 * dy / p.height];
        } else this.spin(dx * 0.01, dy * 0.01);
        this.ask();
      });
      panel.addEventListener("pointerup", (e) => {
        if (from && moved < 4 && e.button === 0) this.onpick(this.regionAt(panel, e.clientX, e.clientY));
        from = null;
      });
      panel.addEventListener("contextmenu", (e) => e.preventDefault());
      panel.addEventListener("wheel", (e) => {
        e.preventDefault();
        this.zoom = Math.min(200, Math.max(0.3, this.zoom * Math.exp(-e.deltaY * 0.0012)));
        this.ask();
      }, { passive: false });
      panel.addEventListener("keydown", (e) => {
        const step = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[e.key];
        if (!step) return;
        e.preventDefault();
        this.spin(...step);
      });
    }
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.ask());
  }

  spin(yaw, pitch) {
    this.yaw += yaw;
    this.pitch = Math.max(-Math.PI, Math.min(0, this.pitch + pitch));
    this.ask();
  }
}
