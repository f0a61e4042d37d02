#include "core/estimation/estimate.h"
