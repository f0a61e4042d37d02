#include "core/payload/inertial_parameters.h"
