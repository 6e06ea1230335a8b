#include "Logic/Geometry/Geodesics.h"
