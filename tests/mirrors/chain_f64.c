/* chain.h in f64. */
#define TIA_NUM_F64
#define CHAIN mirror_chain_f64
#include "chain.h"
