// test.js - for tests in Node.js, node:test and others: files of the disk, and an assertion that writes the differences.
import { AssertionError } from "node:assert";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname } from "node:path";
import { deflateSync } from "node:zlib";
import { load, Picture, TiaError } from "./index.js";

const kit = await load();
export const { version } = kit;
export const crc = (picture) => kit.crc(picture);
export const compare = (a, b) => kit.compare(a, b);
export const raster = (...sizes) => kit.raster(...sizes);

function fromDisk(name) {
    try {
        return readFileSync(name);
    } catch {
        return null;
    }
}

/** Draws a scene; without the option `files`, from the disk. */
export const draw = (scene, size, options = {}) => kit.draw(scene, size, { files: fromDisk, ...options });

const TABLE = Uint32Array.from({ length: 256 }, (_, n) => {
    for (let k = 0; k < 8; k++)
        n = n & 1 ? 0xedb88320 ^ n >>> 1 : n >>> 1;
    return n;
});

function chunk(kind, body) {
    const bytes = Buffer.concat([Buffer.from(kind, "latin1"), body]), head = Buffer.alloc(4), tail = Buffer.alloc(4);
    head.writeUInt32BE(body.length);
    tail.writeUInt32BE(~bytes.reduce((sum, byte) => TABLE[(sum ^ byte) & 255] ^ sum >>> 8, -1) >>> 0);
    return Buffer.concat([head, bytes, tail]);
}

function png({ width, height, rgb }) {
    const header = Buffer.alloc(13), lines = Buffer.alloc((3 * width + 1) * height);
    header.writeUInt32BE(width, 0);
    header.writeUInt32BE(height, 4);
    header.set([8, 2], 8);
    for (let y = 0; y < height; y++)
        lines.set(rgb.subarray(3 * width * y, 3 * width * (y + 1)), (3 * width + 1) * y + 1);
    return Buffer.concat([Buffer.from("\x89PNG\r\n\x1a\n", "latin1"), chunk("IHDR", header), chunk("IDAT", deflateSync(lines)),
        chunk("IEND", Buffer.alloc(0))]);
}

/** Writes a Picture, or the picture of compare, to a .png or .ppm file; its directory is made. */
export function save(path, picture) {
    const seen = picture instanceof Picture ? { width: picture.width, height: picture.height, rgb: picture.rgb() } : picture;
    if (!/\.(png|ppm)$/.test(path))
        throw new TiaError(`${path}: neither .png nor .ppm`);
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, path.endsWith(".png") ? png(seen) : Buffer.concat([Buffer.from(`P6\n${seen.width} ${seen.height}\n255\n`), seen.rgb]));
}

/** Reads a .ppm file that save or `tia` wrote. */
export function loadPicture(path) {
    const bytes = readFileSync(path), head = /^P6\n(\d+) (\d+)\n255\n/.exec(bytes.subarray(0, 40).toString("latin1"));
    if (!head)
        throw new TiaError(`${path}: not a .ppm file that tia wrote`);
    const rgb = bytes.subarray(head[0].length), [width, height] = [Number(head[1]), Number(head[2])];
    if (rgb.length !== 3 * width * height)
        throw new TiaError(`${path}: cut off`);
    const pixels = Uint16Array.from({ length: width * height }, (_, i) =>
        rgb[3 * i] >> 3 << 11 | rgb[3 * i + 1] >> 2 << 5 | rgb[3 * i + 2] >> 3);
    const picture = new Picture(width, height, pixels);
    if (Buffer.compare(picture.rgb(), rgb) !== 0)
        throw new TiaError(`${path}: its colours are not those of RGB565`);
    return picture;
}

const hex = (number, digits) => number.toString(16).padStart(digits, "0");

/** Throws an AssertionError if two pictures differ in a pixel, and writes the picture of compare to the file `difference`. */
export function assertSame(picture, golden, difference = "difference.png") {
    const { differing, picture: seen } = kit.compare(picture, golden);
    if (!differing)
        return;
    const at = picture.pixels.findIndex((pixel, i) => pixel !== golden.pixels[i]);
    save(difference, seen);
    throw new AssertionError({
        message: `${differing} of ${golden.pixels.length} pixels differ, the first at (${at % golden.width}, ` +
            `${Math.floor(at / golden.width)}): ${hex(picture.pixels[at], 4)}, not ${hex(golden.pixels[at], 4)}; CRC ` +
            `${hex(crc(picture), 8)}, not ${hex(crc(golden), 8)}; see ${difference}`,
        actual: hex(crc(picture), 8),
        expected: hex(crc(golden), 8),
        stackStartFn: assertSame,
    });
}
