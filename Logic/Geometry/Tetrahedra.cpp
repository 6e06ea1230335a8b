#include "Logic/Geometry/Tetrahedra.h"
