// index.d.ts - types of index.js; docs/kit.md of tia.

export type Integrator = "whitted" | "ao" | "path";
export type Compare = "never" | "less" | "equal" | "lequal" | "greater" | "notequal" | "gequal" | "always";
export type Operation = "keep" | "zero" | "replace" | "incr" | "decr" | "invert" | "incr_wrap" | "decr_wrap";
export const INTEGRATORS: readonly Integrator[];
export const COMPARE: readonly Compare[];
export const OPERATION: readonly Operation[];
/** The face of a pixel that shows none. */
export const EMPTY: number;

/** A scene, an option or a state that is refused, with the reason in one line. */
export class TiaError extends Error {}

/** A picture of RGB565 pixels, row by row from the top. */
export class Picture {
    constructor(width: number, height: number, pixels: ArrayLike<number>);
    readonly width: number;
    readonly height: number;
    readonly pixels: Uint16Array;
    /** Bytes of 8-bit red, green and blue, as `tia` writes them to files. */
    rgb(): Uint8Array;
}

/** A picture of 8-bit red, green and blue. */
export interface Rgb {
    width: number;
    height: number;
    rgb: Uint8Array;
}

export type Content = string | Uint8Array;

export interface DrawOptions {
    /** The files of the scene: by name, or a function that returns null for those that are not there. */
    files?: Record<string, Content> | ((name: string) => Content | null);
    integrator?: Integrator | null;
    samples?: number;
    seed?: number | null;
    dither?: boolean;
    /** Time of a scene that moves, in seconds. */
    time?: number;
}

export interface Stencil {
    test?: Compare;
    reference?: number;
    mask?: number;
    write?: number;
    fail?: Operation;
    zfail?: Operation;
    zpass?: Operation;
}

export interface State {
    depth?: Compare;
    depthWrite?: boolean;
    tiesByFace?: boolean;
    skipFront?: boolean;
    skipBack?: boolean;
    front?: Stencil;
    back?: Stencil;
}

/** x and y from the upper left corner in 1/256 of a pixel, and the distance w from the eye, 1 or more. */
export type Corner = [x: number, y: number, w: number];

/** Depth and stencil buffers of the exact rasteriser. */
export interface Raster {
    readonly width: number;
    readonly height: number;
    clear(stencil?: number): void;
    triangle(corners: [Corner, Corner, Corner], face: number, state?: State): void;
    faces(): Uint32Array;
    stencil(): Uint8Array;
    /** Frees the buffers: nothing else may be called after this. */
    free(): void;
}

export interface Kit {
    readonly version: string;
    /** Draws a scene file (.tia, .nff, .obj) as `tia -n 1 -s WIDTHxHEIGHT` does. */
    draw(scene: string, size: [width: number, height: number], options?: DrawOptions): Picture;
    /** The CRC-32 that `tia --checksum` prints of the picture. */
    crc(picture: Picture): number;
    /** The number of pixels that differ, and a picture: red where a channel differs by more than a level, else yellow. */
    compare(a: Picture, b: Picture): { differing: number; picture: Rgb };
    raster(width: number, height: number, faces?: number): Raster;
}

export function open(wasm: BufferSource | WebAssembly.Module): Kit;
export function load(): Promise<Kit>;
