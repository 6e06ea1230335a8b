#include "Logic/Geometry/TriangleTree.h"
