#include "core/simulation/simulate.h"
