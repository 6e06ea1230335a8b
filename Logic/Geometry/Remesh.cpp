#include "Logic/Geometry/Remesh.h"
