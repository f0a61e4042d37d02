#include "core/robot/robot_model.h"
