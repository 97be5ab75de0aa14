/* prefetch.h - memory that is about to be written is fetched ahead, where the compiler can tell the processor so. */
#ifndef TIA_READ_MODEL_PREFETCH_H
#define TIA_READ_MODEL_PREFETCH_H

#ifdef __GNUC__
#define PREFETCH(address) __builtin_prefetch(address, 1)
#else
#define PREFETCH(address) ((void)(address))
#endif

#endif
