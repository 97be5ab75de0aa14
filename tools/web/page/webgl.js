// webgl.js - triangles with depth and stencil states by WebGL 2, as bench/conform/trial.h numbers them. For the page
// conform.html and for bench/conform/webgl.py.
'use strict';

// WebGL wants the same reference and masks of the stencil for front and back faces, so a triangle is drawn twice: with back
// faces culled, then with front faces culled. It cannot read stencil values: they are drawn bit by bit into a picture.
// Returns the driver's name and the function that draws a trial; null without WebGL 2.
function openTriangles() {
  const SIDE = 64, canvas = typeof document === 'undefined' ? new OffscreenCanvas(SIDE, SIDE) : document.createElement('canvas');
  canvas.width = canvas.height = SIDE;
  const gl = canvas.getContext('webgl2', {antialias: false});
  if (!gl) return null;
  const shader = (kind, text) => { const s = gl.createShader(kind); gl.shaderSource(s, text); gl.compileShader(s); return s; };
  const program = gl.createProgram();
  gl.attachShader(program, shader(gl.VERTEX_SHADER, '#version 300 es\nin vec4 at; void main() { gl_Position = at; }'));
  gl.attachShader(program, shader(gl.FRAGMENT_SHADER,
    '#version 300 es\nprecision highp float; uniform vec4 colour; out vec4 pixel; void main() { pixel = colour; }'));
  gl.bindAttribLocation(program, 0, 'at');
  gl.linkProgram(program);
  gl.useProgram(program);
  const colour = gl.getUniformLocation(program, 'colour'), depth = gl.createRenderbuffer();
  gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
  gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH24_STENCIL8, SIDE, SIDE);
  const target = () => {
    const frame = gl.createFramebuffer(), pixels = gl.createRenderbuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.bindRenderbuffer(gl.RENDERBUFFER, pixels);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.RGBA8, SIDE, SIDE);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, pixels);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_STENCIL_ATTACHMENT, gl.RENDERBUFFER, depth);
    if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE) throw new Error('no framebuffer');
    return frame;
  };
  const faces = target(), bits = target();
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.enableVertexAttribArray(0);
  gl.vertexAttribPointer(0, 4, gl.FLOAT, false, 0, 0);
  gl.viewport(0, 0, SIDE, SIDE);
  gl.frontFace(gl.CW);   /* pictures are drawn upside down: the first row that is read is the top one */
  gl.disable(gl.DITHER);
  const compares = [gl.NEVER, gl.LESS, gl.EQUAL, gl.LEQUAL, gl.GREATER, gl.NOTEQUAL, gl.GEQUAL, gl.ALWAYS];
  const operations = [gl.KEEP, gl.ZERO, gl.REPLACE, gl.INCR, gl.DECR, gl.INVERT, gl.INCR_WRAP, gl.DECR_WRAP];
  const put = (corners) => {
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(corners), gl.STREAM_DRAW);
    gl.drawArrays(gl.TRIANGLES, 0, corners.length / 4);
  };
  const side = ([test, reference, mask, write, fail, zfail, zpass]) => {
    gl.stencilFunc(compares[test], reference, mask);
    gl.stencilMask(write);
    gl.stencilOp(operations[fail], operations[zfail], operations[zpass]);
  };
  const triangle = (face, t) => {
    const level = t[6], corners = [];
    for (let i = 0; i < 6; i += 2)
      corners.push((t[i] - SIDE * 128) / (SIDE * 128) * level, (t[i + 1] - SIDE * 128) / (SIDE * 128) * level,
             level * (level - 8) / 8, level);
    gl.depthFunc(compares[t[7]]);
    gl.depthMask(!!t[8]);
    gl.colorMask(!!t[9], !!t[9], !!t[9], !!t[9]);
    gl.uniform4f(colour, face / 255, 0, 0, 1);
    for (const [skipped, culled, state] of [[t[10], gl.BACK, t.slice(12, 19)], [t[11], gl.FRONT, t.slice(19, 26)]]) {
      if (skipped) continue;
      gl.cullFace(culled);
      side(state);
      put(corners);
    }
  };
  const clear = (frame, value, stencil) => {
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.colorMask(true, true, true, true);
    gl.depthMask(true);
    gl.stencilMask(255);
    gl.clearColor(value, value, value, value);
    gl.clearStencil(stencil);
  };
  const read = () => {
    const all = new Uint8Array(4 * SIDE * SIDE);
    gl.readPixels(0, 0, SIDE, SIDE, gl.RGBA, gl.UNSIGNED_BYTE, all);
    return all.filter((_, i) => i % 4 === 0);
  };
  const stencils = () => {
    clear(bits, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.CULL_FACE);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE);
    gl.stencilMask(0);
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.KEEP);
    for (let bit = 1; bit < 256; bit *= 2) {
      gl.stencilFunc(gl.EQUAL, bit, bit);
      gl.uniform4f(colour, bit / 255, 0, 0, 0);
      put([-1, -1, 0, 1, 3, -1, 0, 1, -1, 3, 0, 1]);
    }
    gl.disable(gl.BLEND);
    return read();
  };
  const draw = numbers => {
    clear(faces, 1, numbers[1]);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.STENCIL_TEST);
    gl.enable(gl.CULL_FACE);
    for (let i = 0; i < numbers[0]; i++)
      triangle(i, numbers.slice(2 + 26 * i, 28 + 26 * i));
    const shown = read(), stencil = stencils(), error = gl.getError();
    if (error) throw new Error('WebGL error ' + error);
    const bytes = new Uint8Array(2 * SIDE * SIDE);
    bytes.set(shown);
    bytes.set(stencil, SIDE * SIDE);
    return bytes;
  };
  const names = gl.getExtension('WEBGL_debug_renderer_info');
  const renderer = gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  return {driver: `${renderer}, ${gl.getParameter(gl.SUBPIXEL_BITS)} subpixel bits`, draw};
}
