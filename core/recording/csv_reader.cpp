#include "core/recording/csv_reader.h"
