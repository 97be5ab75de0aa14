/* chain.h in fixed point. */
#define CHAIN mirror_chain_q16
#include "chain.h"
