// SPDX-License-Identifier: GPL-3.0-or-later
// A packing by WebGL2: each grain a square on which the fragment shader finds the sphere, each contact a bar as thick as
// its force. Orthographic; the cell turns about its middle.
"use strict";

const sphereShaders = [
  `#version 300 es
  in vec2 corner; in vec4 grain; in float rattler;
  uniform mat3 turn; uniform vec3 middle; uniform vec2 scale; uniform float shrink, cut;
  out vec2 at; out float pale; out float size; out float depth; out float hidden;
  void main() {
    vec3 seen = turn * (grain.xyz - middle);
    size = grain.w * shrink; at = corner; pale = rattler; depth = seen.z;
    hidden = grain.y > cut ? 1.0 : 0.0;
    gl_Position = vec4((seen.xy + corner * size) * scale, 0.0, 1.0);
  }`,
  `#version 300 es
  precision highp float;
  in vec2 at; in float pale; in float size; in float depth; in float hidden;
  uniform vec3 colour, paleColour; uniform float deep;
  out vec4 shown;
  void main() {
    float r2 = dot(at, at);
    if (r2 > 1.0 || hidden > 0.5) discard;
    vec3 normal = vec3(at, sqrt(1.0 - r2));
    float light = 0.35 + 0.65 * max(0.0, dot(normal, normalize(vec3(-0.4, 0.6, 0.8))));
    shown = vec4(mix(colour, paleColour, pale) * light, 1.0);
    gl_FragDepth = 0.5 - 0.5 * (depth + normal.z * size) / deep;
  }`,
];
const barShaders = [
  `#version 300 es
  in vec2 corner; in vec3 from, to; in float force;
  uniform mat3 turn; uniform vec3 middle; uniform vec2 scale; uniform float cut, deep;
  out float across; out float strong; out float hidden;
  void main() {
    vec3 a = turn * (from - middle), b = turn * (to - middle);
    vec2 along = b.xy - a.xy;
    vec2 side = normalize(length(along) > 1e-6 ? vec2(-along.y, along.x) : vec2(1.0, 0.0));
    vec3 seen = mix(a, b, corner.x * 0.5 + 0.5);
    across = corner.y; strong = force;
    hidden = max(from.y, to.y) > cut ? 1.0 : 0.0;
    gl_Position = vec4((seen.xy + side * corner.y * 0.13 * sqrt(force)) * scale, -seen.z / deep, 1.0);
  }`,
  `#version 300 es
  precision highp float;
  in float across; in float strong; in float hidden;
  uniform vec3 colour, paleColour;
  out vec4 shown;
  void main() {
    if (hidden > 0.5) discard;
    shown = vec4(mix(paleColour, colour, clamp(strong / 2.0, 0.15, 1.0)) * (1.0 - 0.5 * across * across), 1.0);
  }`,
];

class PackingView {
  /// Throws where the browser has no WebGL2.
  constructor(canvas) {
    this.canvas = canvas;
    this.gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });
    if (!this.gl) throw new Error("WebGL2 is not available");
    this.begin();
    Object.assign(this, { yaw: 0.5, pitch: 0.35, zoom: 1, forces: false, slice: 1, shape: "sphere", data: null, waiting: false, reference: null, exaggeration: 1 });
    this.listen();
  }

  /// What the graphics processor holds: made anew after it was lost, as on phones where another app was used.
  begin() {
    this.spheres = this.program(sphereShaders, [["grain", 4], ["rattler", 1]]);
    this.bars = this.program(barShaders, [["from", 3], ["to", 3], ["force", 1]]);
  }

  program([vertex, fragment], attributes) {
    const gl = this.gl, program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    const array = gl.createVertexArray(), rows = gl.createBuffer();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 1, -1, -1, 1, 1, 1]), gl.STATIC_DRAW);
    const corner = gl.getAttribLocation(program, "corner");
    gl.enableVertexAttribArray(corner);
    gl.vertexAttribPointer(corner, 2, gl.FLOAT, false, 0, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, rows);
    const stride = attributes.reduce((sum, [, count]) => sum + count, 0);
    let offset = 0;
    for (const [name, count] of attributes) {
      const at = gl.getAttribLocation(program, name);
      gl.enableVertexAttribArray(at);
      gl.vertexAttribPointer(at, count, gl.FLOAT, false, 4 * stride, 4 * offset);
      gl.vertexAttribDivisor(at, 1);
      offset += count;
    }
    const places = new Map();
    const uniform = (name) => {
      if (!places.has(name)) places.set(name, gl.getUniformLocation(program, name));
      return places.get(name);
    };
    return { program, array, rows, stride, uniform, held: null };
  }

  listen() {
    const canvas = this.canvas;
    const turned = (dx, dy) => {
      this.yaw += dx;
      this.pitch = Math.max(-1.5, Math.min(1.5, this.pitch + dy));
      this.ask();
    };
    const zoomed = (factor) => {
      this.zoom = Math.max(0.5, Math.min(6, this.zoom * factor));
      this.ask();
    };
    // One finger turns sideways and lets the page scroll; two pinch.
    const fingers = new Map();
    const apart = () => {
      const [a, b] = [...fingers.values()];
      return Math.hypot(a.x - b.x, a.y - b.y);
    };
    canvas.addEventListener("pointerdown", (event) => {
      fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      canvas.setPointerCapture(event.pointerId);
    });
    for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, (event) => fingers.delete(event.pointerId));
    canvas.addEventListener("pointermove", (event) => {
      if (!fingers.has(event.pointerId)) return;
      const was = fingers.get(event.pointerId), now = { x: event.clientX, y: event.clientY }, before = fingers.size === 2 ? apart() : 0;
      fingers.set(event.pointerId, now);
      if (before) zoomed(apart() / before);
      else turned((now.x - was.x) * 0.01, (now.y - was.y) * 0.01);
    });
    // The wheel scrolls the page; with Ctrl, as where two fingers pinch on a touchpad, it zooms.
    canvas.addEventListener("wheel", (event) => {
      if (!event.ctrlKey) return;
      event.preventDefault();
      zoomed(Math.exp(-event.deltaY * 0.001));
    }, { passive: false });
    canvas.addEventListener("keydown", (event) => {
      const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[event.key];
      if (turns) turned(...turns);
      else if (event.key === "+" || event.key === "-") zoomed(event.key === "+" ? 1.15 : 1 / 1.15);
      else return;
      event.preventDefault();
    });
    new ResizeObserver(() => this.ask()).observe(canvas);
    canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    canvas.addEventListener("webglcontextrestored", () => {
      this.begin();
      this.ask();
    });
  }

  show(data) {
    this.data = data;
    this.ask();
  }
  ask() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.draw();
    });
  }

  draw() {
    const { gl, canvas, data } = this;
    if (gl.isContextLost()) return;
    const ratio = Math.min(2, window.devicePixelRatio || 1);
    canvas.width = Math.max(1, Math.round(canvas.clientWidth * ratio));
    canvas.height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    if (!data || data.grains.length === 0) return;
    gl.enable(gl.DEPTH_TEST);
    const { edge, grains } = this.seen();
    const middle = Array.from(edge, (length) => length / 2);
    const reach = 0.5 * Math.hypot(...edge) + 1;
    const cy = Math.cos(this.yaw), sy = Math.sin(this.yaw), cp = Math.cos(this.pitch), sp = Math.sin(this.pitch);
    // Axis 3 of the packing points up. Columns of the rotation, one after the other.
    const turn = [cy, sp * sy, cp * sy, -sy, sp * cy, cp * cy, 0, cp, -sp];
    const scale = this.zoom / reach;
    const pale = this.colour("--rule");
    const common = (part) => {
      gl.useProgram(part.program);
      gl.bindVertexArray(part.array);
      gl.uniformMatrix3fv(part.uniform("turn"), false, turn);
      gl.uniform3fv(part.uniform("middle"), middle);
      gl.uniform2f(part.uniform("scale"), scale * (canvas.height < canvas.width ? canvas.height / canvas.width : 1), scale * (canvas.width < canvas.height ? canvas.width / canvas.height : 1));
      gl.uniform1f(part.uniform("cut"), this.slice * edge[1]);
      gl.uniform1f(part.uniform("deep"), reach);
    };
    common(this.spheres);
    gl.uniform1f(this.spheres.uniform("shrink"), this.forces ? 0.22 : 1);
    gl.uniform3fv(this.spheres.uniform("colour"), this.colour(this.forces ? "--soft" : `--${this.shape}`));
    gl.uniform3fv(this.spheres.uniform("paleColour"), pale);
    this.instances(this.spheres, grains);
    common(this.bars);
    gl.uniform1f(this.bars.uniform("cut"), Infinity);
    gl.uniform3fv(this.bars.uniform("colour"), this.colour("--soft"));
    gl.uniform3fv(this.bars.uniform("paleColour"), this.colour("--soft"));
    this.instances(this.bars, this.box(edge));
    if (!this.forces) return;
    common(this.bars);
    gl.uniform3fv(this.bars.uniform("colour"), this.colour("--force"));
    gl.uniform3fv(this.bars.uniform("paleColour"), pale);
    this.instances(this.bars, data.contacts);
  }

  /// Grains and cell, with their displacement since the reference multiplied by a factor.
  seen() {
    const { data, reference, exaggeration } = this;
    if (exaggeration === 1 || !reference || this.forces || reference.grains.length !== data.grains.length) return data;
    const edge = data.edge.map((length, axis) => reference.edge[axis] + exaggeration * (length - reference.edge[axis]));
    const grains = data.grains.slice();
    for (let k = 0; k < grains.length; k += 5)
      for (let axis = 0; axis < 3; ++axis) {
        const before = reference.grains[k + axis] / reference.edge[axis];
        const moved = data.grains[k + axis] / data.edge[axis] - before;
        grains[k + axis] = (before + exaggeration * (moved - Math.round(moved))) * edge[axis];
      }
    return { edge, grains };
  }
  /// The twelve edges of the cell, as bars.
  box(edge) {
    const rows = [], corner = (bits) => [0, 1, 2].map((axis) => (bits & (1 << axis) ? edge[axis] : 0));
    for (let bits = 0; bits < 8; ++bits)
      for (let axis = 0; axis < 3; ++axis) if (!(bits & (1 << axis))) rows.push(...corner(bits), ...corner(bits | (1 << axis)), 0.15);
    return new Float32Array(rows);
  }

  /// A colour of the style sheet, "#rrggbb", from 0 to 1.
  colour(name) {
    const text = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
    return [1, 3, 5].map((k) => parseInt(text.slice(k, k + 2), 16) / 255);
  }

  /// Turning does not transfer the rows again.
  instances(part, rows) {
    const gl = this.gl;
    if (part.held !== rows) {
      gl.bindBuffer(gl.ARRAY_BUFFER, part.rows);
      gl.bufferData(gl.ARRAY_BUFFER, rows, gl.DYNAMIC_DRAW);
      part.held = rows;
    }
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, rows.length / part.stride);
  }
}
