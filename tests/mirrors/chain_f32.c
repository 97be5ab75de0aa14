/* chain.h in f32. */
#define TIA_NUM_F32
#define CHAIN mirror_chain_f32
#include "chain.h"
