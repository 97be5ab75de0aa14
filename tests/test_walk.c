/* Walks in integers. */
#include "walk_cases.h"
