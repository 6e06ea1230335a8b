#include "Logic/Geometry/KdTree.h"
