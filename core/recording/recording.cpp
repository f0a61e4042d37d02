#include "core/recording/recording.h"
