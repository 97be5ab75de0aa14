// Options with which tia.c is compiled, see docs/boards.md. TIA_CHUNK, 64, 32 or 16 pixels at once, and TIA_BALL_WORDS, 16 or 8,
// decide on the stack that drawing takes: with 16 and 8 an AVR of 8 KB draws rows of 320 pixels.
#ifdef __AVR__
#define TIA_CHUNK 16
#define TIA_BALL_WORDS 8
#endif
