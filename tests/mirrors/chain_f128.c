/* chain.h in f128. */
#define TIA_NUM_F128
#define CHAIN mirror_chain_f128
#include "chain.h"
