// index.js - pictures with the same bits on every machine, and the exact rasteriser: tia in WebAssembly. docs/kit.md of tia.
// Runs in Node.js and, given the bytes of tia-kit.wasm, in browsers.

export const INTEGRATORS = ["whitted", "ao", "path"];
export const COMPARE = ["never", "less", "equal", "lequal", "greater", "notequal", "gequal", "always"];
export const OPERATION = ["keep", "zero", "replace", "incr", "decr", "invert", "incr_wrap", "decr_wrap"];
export const EMPTY = 0xffffffff; // no face at this pixel
const SIZE_MOST = 8192;

/** A scene, an option or a state that is refused, with the reason in one line. */
export class TiaError extends Error {
    name = "TiaError";
}

function whole(name, value, least, most) {
    if (!Number.isInteger(value) || value < least || value > most)
        throw new TiaError(`${name}: ${value} is not a whole number in ${least}..${most}`);
    return value;
}

function index(names, name) {
    const found = names.indexOf(name);
    if (found < 0)
        throw new TiaError(`"${name}" is none of ${names.join(", ")}`);
    return found;
}

/** A picture of RGB565 pixels, row by row from the top. */
export class Picture {
    constructor(width, height, pixels) {
        this.width = whole("width", width, 1, SIZE_MOST);
        this.height = whole("height", height, 1, SIZE_MOST);
        this.pixels = Uint16Array.from(pixels);
        if (this.pixels.length !== width * height)
            throw new TiaError(`${this.pixels.length} pixels are no picture of ${width}x${height}`);
    }

    /** Bytes of 8-bit red, green and blue, as `tia` writes them to files. */
    rgb() {
        const bytes = new Uint8Array(3 * this.pixels.length);
        this.pixels.forEach((p, i) => {
            const r = p >> 11, g = p >> 5 & 63, b = p & 31;
            bytes.set([r << 3 | r >> 2, g << 2 | g >> 4, b << 3 | b >> 2], 3 * i);
        });
        return bytes;
    }
}

function sameSize(a, b) {
    if (a.width !== b.width || a.height !== b.height)
        throw new TiaError(`${a.width}x${a.height} and ${b.width}x${b.height} pixels: the sizes differ`);
}

class Kit {
    #exports;
    #files = {};
    #kept = new Map();

    constructor(module) {
        const text = (at, length) => new TextDecoder().decode(new Uint8Array(this.#exports.memory.buffer, at, length));
        const host = {
            file_size: (name, length) => {
                const content = this.#find(text(name, length));
                return content ? content.length : -1;
            },
            file_read: (name, length, to) => this.#bytes().set(this.#find(text(name, length)), to),
        };
        this.#exports = new WebAssembly.Instance(module, { host }).exports;
        this.version = this.#string(this.#exports.kit_version());
    }

    #find(name) {
        if (!this.#kept.has(name)) {
            const found = typeof this.#files === "function" ? this.#files(name)
                : Object.hasOwn(this.#files, name) ? this.#files[name] : null;
            const content = typeof found === "string" ? new TextEncoder().encode(found) : found;
            if (content != null && !(content instanceof Uint8Array))
                throw new TiaError(`${name}: a file is a string or a Uint8Array`);
            this.#kept.set(name, content ?? null);
        }
        return this.#kept.get(name);
    }

    #bytes() {
        return new Uint8Array(this.#exports.memory.buffer);
    }

    #string(at) {
        const bytes = this.#bytes();
        return new TextDecoder().decode(bytes.subarray(at, bytes.indexOf(0, at)));
    }

    #why() {
        return new TiaError(this.#string(this.#exports.kit_why()));
    }

    // Calls `use` with the addresses of copies of arrays, and frees these.
    #with(arrays, use) {
        const addresses = [];
        try {
            for (const array of arrays) {
                const at = this.#exports.kit_alloc(array.byteLength) >>> 0;
                if (!at)
                    throw new TiaError("memory: exhausted");
                addresses.push(at);
                this.#bytes().set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength), at);
            }
            return use(...addresses);
        } finally {
            addresses.forEach((at) => this.#exports.kit_free(at));
        }
    }

    draw(scene, size, options = {}) {
        const [width, height] = size;
        const { files = {}, integrator = null, samples = 0, seed = null, dither = false, time = 0, ...rest } = options;
        if (Object.keys(rest).length)
            throw new TiaError(`no such option: ${Object.keys(rest)[0]}`);
        const numbers = Int32Array.of(whole("width", width, 1, SIZE_MOST), whole("height", height, 1, SIZE_MOST),
            integrator === null ? -1 : index(INTEGRATORS, integrator), whole("samples", samples, 0, 1 << 24),
            seed === null ? -1 : whole("seed", seed, 0, 0x7fffffff), dither ? 1 : 0,
            whole("time", Math.round(time * 65536), 0, 0x7fffffff));
        const name = new TextEncoder().encode(`${scene}\0`);
        this.#files = files;
        this.#kept.clear();
        return this.#with([name, numbers, new Uint16Array(width * height)], (at, from, to) => {
            if (this.#exports.kit_draw(at, from, to))
                throw this.#why();
            return new Picture(width, height, new Uint16Array(this.#exports.memory.buffer, to, width * height));
        });
    }

    crc(picture) {
        return this.#with([picture.pixels], (at) => this.#exports.kit_crc(at, picture.pixels.length) >>> 0);
    }

    compare(a, b) {
        sameSize(a, b);
        const count = a.pixels.length;
        return this.#with([a.pixels, b.pixels, new Uint8Array(3 * count)], (one, other, to) => {
            const differing = this.#exports.kit_compare(one, other, count, to) >>> 0;
            return { differing, picture: { width: a.width, height: a.height, rgb: this.#bytes().slice(to, to + 3 * count) } };
        });
    }

    raster(width, height, faces = 65536) {
        const most = 0xffffffff;
        const at = this.#exports.kit_raster_create(whole("width", width, 0, most), whole("height", height, 0, most),
            whole("faces", faces, 0, most)) >>> 0;
        if (!at)
            throw this.#why();
        const exports = this.#exports, count = width * height;
        return {
            width,
            height,
            clear: (stencil = 0) => exports.kit_raster_clear(at, stencil & 255),
            triangle: (corners, face, state = {}) => {
                const flat = corners.flat();
                if (flat.length !== 9)
                    throw new TiaError("a triangle has three corners of three numbers");
                flat.forEach((number) => whole("corner", number, -(2 ** 31), 2 ** 31 - 1));
                this.#with([stateNumbers(state), Int32Array.from(flat)], (from, to) => {
                    if (exports.kit_raster_triangle(at, from, to, whole("face", face, 0, most)))
                        throw this.#why();
                });
            },
            faces: () => new Uint32Array(exports.memory.buffer, exports.kit_raster_faces(at), count).slice(),
            stencil: () => new Uint8Array(exports.memory.buffer, exports.kit_raster_stencil(at), count).slice(),
            free: () => exports.kit_raster_free(at),
        };
    }
}

function known(given, defaults) {
    const rest = Object.keys(given).filter((key) => !(key in defaults));
    if (rest.length)
        throw new TiaError(`no such member of a state: ${rest[0]}`);
    return { ...defaults, ...given };
}

function sideNumbers(side) {
    const s = known(side, { test: "always", reference: 0, mask: 255, write: 255, fail: "keep", zfail: "keep", zpass: "keep" });
    return [index(COMPARE, s.test), s.reference, s.mask, s.write, index(OPERATION, s.fail), index(OPERATION, s.zfail),
        index(OPERATION, s.zpass)];
}

function stateNumbers(state) {
    const s = known(state, { depth: "less", depthWrite: true, tiesByFace: false, skipFront: false, skipBack: false, front: {}, back: {} });
    return Int32Array.of(index(COMPARE, s.depth), s.depthWrite, s.tiesByFace, s.skipFront, s.skipBack, ...sideNumbers(s.front),
        ...sideNumbers(s.back));
}

/** Prepares the kit from the bytes or the compiled module of tia-kit.wasm. */
export function open(wasm) {
    return new Kit(wasm instanceof WebAssembly.Module ? wasm : new WebAssembly.Module(wasm));
}

/** Prepares the kit with the module of this package. */
export async function load() {
    const url = new URL("./tia-kit.wasm", import.meta.url);
    if (url.protocol !== "file:")
        return open(await WebAssembly.compileStreaming(fetch(url)));
    const { readFile } = await import("node:fs/promises");
    return open(await readFile(url));
}
