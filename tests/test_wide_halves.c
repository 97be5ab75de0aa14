/* Products by halves. */
#define TIA_NO_INT128
#include "wide_cases.h"
