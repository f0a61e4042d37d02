#include "core/wrench/regressor.h"
