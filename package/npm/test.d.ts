// test.d.ts - types of test.js; docs/kit.md of tia.
import type { DrawOptions, Picture, Raster, Rgb } from "./index.js";

export const version: string;
/** Draws a scene; without the option `files`, from the disk. */
export function draw(scene: string, size: [width: number, height: number], options?: DrawOptions): Picture;
export function crc(picture: Picture): number;
export function compare(a: Picture, b: Picture): { differing: number; picture: Rgb };
export function raster(width: number, height: number, faces?: number): Raster;
/** Writes a Picture, or the picture of compare, to a .png or .ppm file; its directory is made. */
export function save(path: string, picture: Picture | Rgb): void;
/** Reads a .ppm file that save or `tia` wrote. */
export function loadPicture(path: string): Picture;
/** Throws an AssertionError if a pixel differs, and writes the picture of compare to the file `difference`. */
export function assertSame(picture: Picture, golden: Picture, difference?: string): void;
