#include "core/motion/motion.h"
