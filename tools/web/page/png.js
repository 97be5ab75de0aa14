// png.js - writes PNG, ISO/IEC 15948: RGB with 8 or 16 bits a channel.

const CRC = Uint32Array.from({length: 256}, (_, n) => { for (let k = 0; k < 8; k++) n = n & 1 ? n >>> 1 ^ 0xedb88320 : n >>> 1; return n; });

function crc32(bytes) {
  let crc = ~0;
  for (const byte of bytes) crc = CRC[(crc ^ byte) & 255] ^ crc >>> 8;
  return ~crc >>> 0;
}

function chunk(name, data) {
  const bytes = new Uint8Array(12 + data.length), view = new DataView(bytes.buffer);
  view.setUint32(0, data.length);
  bytes.set(new TextEncoder().encode(name), 4);
  bytes.set(data, 8);
  view.setUint32(8 + data.length, crc32(bytes.subarray(4, 8 + data.length)));
  return bytes;
}

const deflate = bytes => new Response(new Blob([bytes]).stream().pipeThrough(new CompressionStream('deflate'))).arrayBuffer();

// `samples`: red, green and blue of each pixel, Uint8Array or Uint16Array; `significant`: bits of each channel that mean
// something; `linear`: they are linear light.
export async function png(width, height, samples, {significant = null, linear = false} = {}) {
  const depth = 8 * samples.BYTES_PER_ELEMENT, row = 3 * width * depth / 8, raw = new Uint8Array(height * (row + 1)), header = new DataView(new ArrayBuffer(13));
  for (let y = 0, at = 0; y < height; y++) {
    raw[at++] = 0; // no filter
    for (const value of samples.subarray(3 * width * y, 3 * width * (y + 1))) {
      if (depth === 16) raw[at++] = value >> 8;
      raw[at++] = value & 255;
    }
  }
  header.setUint32(0, width);
  header.setUint32(4, height);
  [depth, 2, 0, 0, 0].forEach((byte, i) => header.setUint8(8 + i, byte)); // colour type 2: RGB
  const gamma = new DataView(new ArrayBuffer(4));
  gamma.setUint32(0, 100000); // 1
  return new Blob([Uint8Array.of(137, 80, 78, 71, 13, 10, 26, 10), chunk('IHDR', new Uint8Array(header.buffer)),
    ...(significant ? [chunk('sBIT', Uint8Array.from(significant))] : []),
    ...(linear ? [chunk('gAMA', new Uint8Array(gamma.buffer))] : []), chunk('IDAT', new Uint8Array(await deflate(raw))),
    chunk('IEND', new Uint8Array(0))], {type: 'image/png'});
}

// Red, green and blue of RGBA pixels.
export const withoutAlpha = rgba => Uint8Array.from({length: rgba.length / 4 * 3}, (_, i) => rgba[Math.floor(i / 3) * 4 + i % 3]);
