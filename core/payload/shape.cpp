#include "core/payload/shape.h"
