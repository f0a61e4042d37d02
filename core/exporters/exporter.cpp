#include "core/exporters/exporter.h"
