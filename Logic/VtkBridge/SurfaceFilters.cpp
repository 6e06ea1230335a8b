#include "Logic/VtkBridge/SurfaceFilters.h"
